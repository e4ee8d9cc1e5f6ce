// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <tuple>
#include <utility>

#include "gl/driver.h"
#include "render/frame/frame_job.h"
#include "render/gpu/stretched_picture.h"
#include "render/surfaces/inspection_drawer.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina {

Renderer::Renderer(std::shared_ptr<RenderResources> shared)
    : shared_(std::move(shared)), job_(std::make_unique<FrameJob>(shared_)) {}

Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(Options options) {
    if (auto checked = gl::checkVersion(); !checked) {
        return tl::unexpected(checked.error());
    }
    auto shared = std::make_shared<RenderResources>(std::move(options.programCache));
    shared->shadows.setLimits({options.shadowTexels, options.shadowBytes});
    return std::unique_ptr<Renderer>(new Renderer(std::move(shared)));
}

std::unique_ptr<Renderer> Renderer::forAnotherView() const {
    return std::unique_ptr<Renderer>(new Renderer(shared_));
}

void Renderer::setCatalog(std::shared_ptr<const Catalog> catalog) {
    shared_->setCatalog(std::move(catalog));
}

const Catalog* Renderer::catalog() const {
    return shared_->catalog.get();
}

void Renderer::setTextures(TextureSource source) {
    shared_->textures.setSource(std::move(source));
}

void Renderer::setTables(MeasuredStore::Source source) {
    shared_->measured.setSource(std::move(source));
}

FrameJob& Renderer::begin(const Scene& scene, const View& view, const MeshSource& meshes,
                          FramePurpose purpose) {
    if (purpose == FramePurpose::Window || purpose == FramePurpose::Sketch) {
        inspection_.reset();
    }
    job_->begin(scene, view, meshes, purpose);
    return *job_;
}

/// Draws all the samples of an environment that are wanted, which may take several frames; returns
/// false on an error.
bool Renderer::drawAll(const Scene& scene, const View& view, const MeshSource& meshes) {
    View part = view;
    FrameJob& job = begin(scene, part, meshes, FramePurpose::Capture);
    job.step(FrameJob::never);
    part.isContinued = true;
    int samples = job.environmentSamples();
    while (!job.failure() && samples > 0 && samples < view.environmentSamples) {
        part.environmentSamples = view.environmentSamples - samples;
        begin(scene, part, meshes, FramePurpose::Capture).step(FrameJob::never);
        samples = job.environmentSamples();
    }
    return !job.failure();
}

const FrameReport& Renderer::draw(const Scene& scene, const View& view, const MeshSource& meshes,
                                  unsigned framebuffer) {
    inspection_.reset();
    if (drawAll(scene, view, meshes)) {
        job_->show(framebuffer);
    }
    return job_->report();
}

void Renderer::showInWindow(const StretchedPicture& picture, const OverlayPicture& overlay) {
    const ScreenTarget window{0, picture.size()};
    if (!shared_->catalog || !picture.draw(window, *shared_->catalog, shared_->programs())) {
        picture.show(window.framebuffer, window.size);
    }
    if (shared_->catalog && !overlay.isEmpty()) {
        // Without its program the picture is there, and a frame has the same errors.
        std::ignore = overlay.draw(window, *shared_->catalog, shared_->programs());
    }
}

void Renderer::showUndistorted(const StretchedPicture& picture, const ScreenTarget& target) {
    if (!shared_->catalog ||
        !picture.drawUndistorted(target, *shared_->catalog, shared_->programs())) {
        picture.show(target.framebuffer, target.size);
    }
}

Result<Image> Renderer::capture(const Scene& scene, const View& view, const MeshSource& meshes,
                                bool display) {
    if (!(view.isContinued && job_->holdsPicture(view.size))) {
        drawAll(scene, view, meshes);
    }
    return job_->read(display, scene.exposure);
}

InspectionDrawer& Renderer::inspection() {
    if (!inspection_) {
        inspection_ = std::make_unique<InspectionDrawer>(*shared_);
    }
    return *inspection_;
}

SurfaceBufferDrawer& Renderer::surfaces() {
    if (!surfaces_) {
        surfaces_ = std::make_unique<SurfaceBufferDrawer>(*shared_);
    }
    return *surfaces_;
}

const FrameReport& Renderer::report() const {
    return inspection_ ? inspection_->report() : job_->report();
}

} // namespace patina
