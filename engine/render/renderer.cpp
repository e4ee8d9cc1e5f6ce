// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <epoxy/gl.h>

#include "gl/driver.h"
#include "render/capture_image.h"
#include "render/frame_drawer.h"

namespace patina {

class Renderer::Implementation : public FrameDrawer {
  public:
    using FrameDrawer::FrameDrawer;
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

const FrameReport& Renderer::draw(const Scene& scene, const View& view, const MeshSource& meshes,
                                  unsigned framebuffer) {
    if (implementation_->drawLinear(scene, view, meshes)) {
        implementation_->show(scene, view, framebuffer);
    }
    return implementation_->report();
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

const FrameReport& Renderer::report() const {
    return implementation_->report();
}

} // namespace patina
