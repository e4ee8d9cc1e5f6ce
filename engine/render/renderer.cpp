// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <algorithm>
#include <optional>

#include <epoxy/gl.h>

#include "gl/driver.h"
#include "render/capture_image.h"
#include "render/frame_drawer.h"
#include "render/inspection_drawer.h"

namespace patina {
namespace {

/// What a frame of a window takes of images into the GPU's memory: some milliseconds.
constexpr std::size_t textureBytesAtOnce = std::size_t(8) << 20;

/// So long a frame may take that might be a quick one.
constexpr std::chrono::milliseconds firstPatience{80};

} // namespace

class Renderer::Implementation : public FrameDrawer {
  public:
    explicit Implementation(const std::filesystem::path& programCache)
        : FrameDrawer(programCache), programCache_(programCache) {}

    void setCatalog(std::shared_ptr<const Catalog> catalog) {
        catalog_ = catalog;
        FrameDrawer::setCatalog(std::move(catalog));
        if (inspection_) {
            inspection_->setCatalog(catalog_);
        }
    }

    /// Made when it is first asked for.
    InspectionDrawer& inspection() {
        if (!inspection_) {
            inspection_ = std::make_unique<InspectionDrawer>(programCache_, meshStore(),
                                                             textureStore(), shadowMaps());
            inspection_->setCatalog(catalog_);
        }
        return *inspection_;
    }

    void endInspection() { inspection_.reset(); }

    const FrameReport& lastReport() const {
        return inspection_ ? inspection_->report() : FrameDrawer::report();
    }

    bool drawLinear(const Scene& scene, const View& view, const MeshSource& meshes) {
        limitTextures(GpuTextureStore::everything);
        return begin(scene, view, meshes) && proceed(scene, view, never);
    }

    /// What the frame that is drawn in steps shows.
    Scene steppedScene;
    std::optional<Scene> steppedEffects;
    View steppedView;

  private:
    std::filesystem::path programCache_;
    std::shared_ptr<const Catalog> catalog_;
    std::unique_ptr<InspectionDrawer> inspection_;
};

Renderer::Renderer() = default;
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(Options options) {
    if (auto checked = gl::checkVersion(); !checked) {
        return tl::unexpected(checked.error());
    }
    std::unique_ptr<Renderer> renderer(new Renderer());
    renderer->implementation_ = std::make_unique<Implementation>(std::move(options.programCache));
    return renderer;
}

void Renderer::setCatalog(std::shared_ptr<const Catalog> catalog) {
    implementation_->setCatalog(std::move(catalog));
}

void Renderer::setTextures(TextureSource source) {
    implementation_->textureStore().setSource(std::move(source));
}

const FrameReport& Renderer::draw(const Scene& scene, const View& view, const MeshSource& meshes,
                                  unsigned framebuffer) {
    implementation_->endInspection();
    if (implementation_->drawLinear(scene, view, meshes)) {
        implementation_->show(scene, view, framebuffer);
    }
    return implementation_->report();
}

bool Renderer::drawSmall(const Scene& scene, const View& view, const MeshSource& meshes,
                         unsigned framebuffer) {
    implementation_->endInspection();
    implementation_->limitTextures(textureBytesAtOnce);
    if (!implementation_->begin(scene, view, meshes)) {
        return true;
    }
    const bool isLarge = implementation_->isLarge();
    const FrameBands::Pace pace = implementation_->pace();
    if (!isLarge && pace == FrameBands::Pace::Quick) {
        implementation_->proceed(scene, view, FrameDrawer::never);
        implementation_->show(scene, view, framebuffer);
        return true;
    }
    implementation_->steppedScene = scene;
    implementation_->steppedView = view;
    if (view.effects != nullptr) {
        implementation_->steppedView.effects =
            &implementation_->steppedEffects.emplace(*view.effects);
    }
    const bool isDone = !isLarge && pace == FrameBands::Pace::Unknown && proceed(firstPatience);
    if (isDone) {
        show(framebuffer);
    }
    return isDone;
}

void Renderer::noteTime(double milliseconds) {
    implementation_->noteTime(milliseconds);
}

bool Renderer::proceed(std::chrono::milliseconds patience) {
    return implementation_->proceed(implementation_->steppedScene, implementation_->steppedView,
                                    std::chrono::steady_clock::now() + patience);
}

void Renderer::show(unsigned framebuffer) {
    implementation_->show(implementation_->steppedScene, implementation_->steppedView, framebuffer);
}

bool Renderer::foresee(const Scene& scene, const View& view, const MeshSource& meshes) {
    return implementation_->foresee(scene, view, meshes);
}

bool Renderer::hasMeshesOf(const Scene& scene) const {
    return std::ranges::equal(implementation_->steppedScene.objects, scene.objects,
                              [](const Object& a, const Object& b) {
                                  return a.visible == b.visible && a.mesh == b.mesh;
                              });
}

Result<Image> Renderer::capture(const Scene& scene, const View& view, const MeshSource& meshes,
                                bool display) {
    if (!implementation_->drawLinear(scene, view, meshes)) {
        return tl::unexpected(implementation_->report().messages.front());
    }
    if (!display) {
        return readLinear(implementation_->linearFramebuffer(), view.size, scene.exposure);
    }
    return readDisplay(
        view.size, [&](unsigned framebuffer) { implementation_->show(scene, view, framebuffer); });
}

const FrameReport& Renderer::drawInspection(const Scene& scene, const View& view,
                                            const MeshSource& meshes, unsigned framebuffer) {
    InspectionDrawer& inspection = implementation_->inspection();
    if (inspection.drawLinear(scene, view, meshes)) {
        inspection.show(scene, view, framebuffer);
    }
    return inspection.report();
}

Result<Image> Renderer::captureInspection(const Scene& scene, const View& view,
                                          const MeshSource& meshes, bool display) {
    InspectionDrawer& inspection = implementation_->inspection();
    if (auto drawn = inspection.drawLinear(scene, view, meshes); !drawn) {
        return tl::unexpected(drawn.error());
    }
    if (!display) {
        return readLinear(inspection.linearFramebuffer(), view.size, 0.0);
    }
    return readDisplay(view.size, [&](unsigned target) { inspection.show(scene, view, target); });
}

Result<std::optional<PixelProbe>> Renderer::probe(const Scene& scene, const View& view,
                                                  const MeshSource& meshes, glm::ivec2 pixel) {
    return implementation_->inspection().probe(scene, view, meshes, pixel);
}

void Renderer::releaseTargets() {
    implementation_->releaseTargets();
}

const FrameReport& Renderer::report() const {
    return implementation_->lastReport();
}

} // namespace patina
