// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/timed_frames.h"

#include <utility>

#include <epoxy/gl.h>

#include "render/frame/frame_job.h"
#include "render/gpu/hdr_target.h"

namespace patina {

Result<std::unique_ptr<TimedFrames>> TimedFrames::create(Supplies supplies, glm::ivec2 size,
                                                         std::filesystem::path programCache) {
    if (auto checked = checkPictureSize(size); !checked) {
        return tl::unexpected(checked.error());
    }
    auto renderer = Renderer::create({std::move(programCache)});
    if (!renderer) {
        return tl::unexpected(renderer.error());
    }
    (*renderer)->setCatalog(supplies.catalog);
    if (supplies.textures) {
        (*renderer)->setTextures(supplies.textures);
    }
    return std::unique_ptr<TimedFrames>(
        new TimedFrames(std::move(supplies), size, std::move(*renderer)));
}

TimedFrames::TimedFrames(Supplies supplies, glm::ivec2 size, std::unique_ptr<Renderer> renderer)
    : supplies_(std::move(supplies)), renderer_(std::move(renderer)),
      color_(gl::Texture::create(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE)),
      target_(gl::Framebuffer::create()) {
    target_.attachColor(color_);
}

void TimedFrames::resize(glm::ivec2 size) {
    color_ = gl::Texture::create(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    target_.attachColor(color_);
}

double TimedFrames::timeOf(const Scene& scene, const View& view) {
    if (draw(scene, view).shadowMaps > 0) {
        draw(scene, view);
    }
    return timer_.milliseconds();
}

std::vector<PassStopwatch::Lap> TimedFrames::passesOf(const Scene& scene, const View& view) {
    PassStopwatch stopwatch;
    renderer_->job().setStopwatch(&stopwatch);
    draw(scene, view);
    renderer_->job().setStopwatch(nullptr);
    return stopwatch.laps();
}

const FrameReport& TimedFrames::draw(const Scene& scene, const View& view) {
    View sized = view;
    sized.size = color_.size();
    timer_.begin();
    const FrameReport& frame = renderer_->draw(scene, sized, supplies_.meshes, target_.name());
    timer_.end();
    glFinish();
    timer_.collect();
    if (frame.messages.size() > frame.warnings) {
        problems_ = frame.messages;
    }
    return frame;
}

} // namespace patina
