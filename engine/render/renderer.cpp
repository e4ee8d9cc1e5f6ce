// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <algorithm>
#include <optional>

#include <epoxy/gl.h>

#include "gl/driver.h"
#include "render/frame/frame_drawer.h"
#include "render/gpu/capture_image.h"
#include "render/gpu/hdr_target.h"
#include "render/gpu/stretched_picture.h"
#include "render/surfaces/inspection_drawer.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

/// What a frame of a window takes of images into the GPU's memory: some milliseconds.
constexpr std::size_t textureBytesAtOnce = std::size_t(8) << 20;

/// So long a frame may take that might be a quick one, with the images it is drawn into. What
/// shows it in the window takes some 40 ms more on a slow screen.
constexpr std::chrono::milliseconds firstPatience{40};

/// A whole frame that takes no longer needs no sketch, which has about this share of its work.
constexpr std::chrono::milliseconds longestQuick{48};
constexpr int sketchShare = 8;

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
        surfaces_.reset();
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

    /// Made when it is first asked for.
    SurfaceBufferDrawer& surfaces() {
        if (!surfaces_) {
            surfaces_ = std::make_unique<SurfaceBufferDrawer>(programCache_, meshStore(),
                                                              textureStore(), shadowMaps());
            surfaces_->setCatalog(catalog_);
        }
        return *surfaces_;
    }

    const FrameReport& lastReport() const {
        return inspection_ ? inspection_->report() : FrameDrawer::report();
    }

    /// With all the samples of an environment that are wanted, which may take several frames.
    bool drawLinear(const Scene& scene, const View& view, const MeshSource& meshes) {
        endSketch();
        limitTextures(GpuTextureStore::everything);
        View part = view;
        bool drawn = begin(scene, part, meshes) && proceed(scene, part, never);
        part.isContinued = true;
        while (drawn && environment().isIn() &&
               environment().samples() < view.environmentSamples) {
            part.environmentSamples = view.environmentSamples - environment().samples();
            drawn = begin(scene, part, meshes) && proceed(scene, part, never);
        }
        return drawn;
    }

    /// Keeps what the frame that was begun shows, for its next steps.
    void keep(const Scene& scene, const View& view) {
        steppedScene = scene;
        steppedView = view;
        if (view.effects != nullptr) {
            steppedView.effects = &steppedEffects.emplace(*view.effects);
        }
    }

    bool goOn(Clock::time_point limit) { return proceed(steppedScene, steppedView, limit); }

    /// Half as wide and high as the view, with one sample per pixel. False where so many triangles
    /// are seen that this would take hardly less.
    bool beginSketch(const Scene& scene, const View& view, const MeshSource& meshes) {
        endSketch();
        exchangeTarget(spareTarget_); // the frames' own one need not be made anew
        sketchedSize = view.size;
        View few = view;
        few.size = glm::max(view.size / 2, glm::ivec2(1));
        few.samples = 1;
        if (!begin(scene, few, meshes) || isLarge()) {
            endSketch();
            return false;
        }
        keep(scene, few);
        return true;
    }

    void endSketch() {
        if (sketchedSize) {
            sketchedSize.reset();
            exchangeTarget(spareTarget_);
            spareTarget_ = HdrTarget();
        }
    }

    void showSketch(unsigned framebuffer) {
        const StretchedPicture picture(steppedView.size);
        FrameDrawer::show(steppedScene, steppedView, picture.framebuffer());
        picture.show(framebuffer, *sketchedSize);
    }

    /// The picture that was drawn last.
    Result<Image> read(const Scene& scene, const View& view, bool display) {
        if (!display) {
            return readLinear(linearFramebuffer(), view.size, scene.exposure);
        }
        return readDisplay(view.size,
                           [&](unsigned framebuffer) { show(scene, view, framebuffer); });
    }

    /// What the frame that is drawn in steps shows.
    Scene steppedScene;
    std::optional<Scene> steppedEffects;
    View steppedView;
    std::optional<glm::ivec2> sketchedSize; ///< of the view, when that frame is a sketch

  private:
    HdrTarget spareTarget_;
    std::filesystem::path programCache_;
    std::shared_ptr<const Catalog> catalog_;
    std::unique_ptr<InspectionDrawer> inspection_;
    std::unique_ptr<SurfaceBufferDrawer> surfaces_;
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
    implementation_->endSketch();
    implementation_->limitTextures(textureBytesAtOnce);
    const Clock::time_point began = Clock::now();
    if (!implementation_->plan(scene, view, meshes)) {
        return true;
    }
    if (!implementation_->prepareSome(scene, view)) {
        return true;
    }
    if (!implementation_->isPrepared()) {
        implementation_->keep(scene, view);
        return false;
    }
    const bool isSlow = Clock::now() - began > firstPatience / 2; // and drawing may compile, too
    const bool isLarge = implementation_->isLarge();
    const RowTiles::Pace pace = implementation_->pace();
    if (!isLarge && pace == RowTiles::Pace::Quick && !isSlow) {
        implementation_->proceed(scene, view, FrameDrawer::never);
        implementation_->show(scene, view, framebuffer);
        return true;
    }
    implementation_->keep(scene, view);
    const bool isDone = !isLarge && pace == RowTiles::Pace::Unknown && !isSlow &&
                        implementation_->goOn(began + firstPatience);
    if (isDone) {
        show(framebuffer);
    }
    return isDone;
}

void Renderer::noteTime(double milliseconds) {
    implementation_->noteTime(milliseconds);
}

Renderer::Sketch Renderer::sketch(const Scene& scene, const View& view, const MeshSource& meshes,
                                  unsigned framebuffer, std::chrono::milliseconds patience) {
    implementation_->endInspection();
    implementation_->limitTextures(textureBytesAtOnce);
    const Clock::time_point began = Clock::now();
    if (!implementation_->beginSketch(scene, view, meshes)) {
        return Sketch::Needless;
    }
    if (!proceed(patience)) {
        return Sketch::Begun;
    }
    if (Clock::now() - began < longestQuick / sketchShare) {
        implementation_->endSketch();
        return Sketch::Needless;
    }
    show(framebuffer);
    return Sketch::Shown;
}

bool Renderer::proceed(std::chrono::milliseconds patience) {
    return implementation_->goOn(Clock::now() + patience);
}

void Renderer::show(unsigned framebuffer) {
    if (implementation_->sketchedSize) {
        implementation_->showSketch(framebuffer);
    } else {
        implementation_->show(implementation_->steppedScene, implementation_->steppedView,
                              framebuffer);
    }
}

std::uint64_t Renderer::missingPrograms(const Scene& scene, const View& view,
                                        const MeshSource& meshes) {
    implementation_->endSketch();
    return implementation_->missingPrograms(scene, view, meshes);
}

void Renderer::makeTargets(const Scene& scene, const View& view, const MeshSource& meshes) {
    implementation_->endSketch();
    implementation_->makeTargets(scene, view, meshes);
}

bool Renderer::prewarm(const Scene& scene, const View& view, const MeshSource& meshes) {
    implementation_->endSketch();
    return implementation_->prewarm(scene, view, meshes);
}

int Renderer::environmentSamples() const {
    return implementation_->environment().samples();
}

bool Renderer::hasMeshesOf(const Scene& scene) const {
    return std::ranges::equal(implementation_->steppedScene.objects, scene.objects,
                              [](const Object& a, const Object& b) {
                                  return a.visible == b.visible && a.mesh == b.mesh;
                              });
}

Result<Image> Renderer::capture(const Scene& scene, const View& view, const MeshSource& meshes,
                                bool display) {
    const bool isThere = view.isContinued && implementation_->environment().holds(view.size);
    if (!isThere && !implementation_->drawLinear(scene, view, meshes)) {
        return tl::unexpected(implementation_->report().messages.front());
    }
    return implementation_->read(scene, view, display);
}

Result<void> Renderer::beginCapture(const Scene& scene, const View& view,
                                    const MeshSource& meshes) {
    implementation_->endInspection();
    implementation_->endSketch();
    implementation_->limitTextures(GpuTextureStore::everything);
    if (!implementation_->begin(scene, view, meshes)) {
        return tl::unexpected(implementation_->report().messages.front());
    }
    implementation_->keep(scene, view);
    return {};
}

Result<Image> Renderer::captured(bool display) {
    return implementation_->read(implementation_->steppedScene, implementation_->steppedView,
                                 display);
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

Result<SurfaceBuffer> Renderer::captureSurfaces(const Scene& scene, const View& view,
                                                const MeshSource& meshes, int round) {
    return implementation_->surfaces().capture(scene, view, meshes, round);
}

void Renderer::releaseTargets() {
    implementation_->endSketch();
    implementation_->releaseTargets();
}

const FrameReport& Renderer::report() const {
    return implementation_->lastReport();
}

} // namespace patina
