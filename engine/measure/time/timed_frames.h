// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "gl/framebuffer.h"
#include "measure/time/frame_timer.h"
#include "render/renderer.h"

namespace patina {

/// Draws whole frames, to the display's values, and times them. Made, used and destroyed with one
/// context current.
class TimedFrames {
  public:
    /// Holds what frames are drawn with. The catalogue and the meshes must stay.
    struct Supplies {
        std::shared_ptr<const Catalog> catalog;
        MeshSource meshes;
        TextureSource textures{}; ///< of the materials' images; empty: none are shown
    };

    static Result<std::unique_ptr<TimedFrames>> create(Supplies supplies, glm::ivec2 size,
                                                       std::filesystem::path programCache);

    /// Milliseconds of a frame of the size, whatever the view says about that. Shadow maps are
    /// drawn when something has changed: a frame that had to draw some is drawn again.
    double timeOf(const Scene& scene, const View& view);

    glm::ivec2 size() const { return color_.size(); }
    void resize(glm::ivec2 size);
    std::string method() const { return std::string(timer_.methodText()); }
    Renderer& renderer() { return *renderer_; }
    const MeshSource& meshes() const { return supplies_.meshes; }

    /// Returns what could not be drawn in the last frame that lacked something.
    const Errors& problems() const { return problems_; }

  private:
    TimedFrames(Supplies supplies, glm::ivec2 size, std::unique_ptr<Renderer> renderer);

    const FrameReport& draw(const Scene& scene, const View& view);

    Supplies supplies_;
    std::unique_ptr<Renderer> renderer_;
    gl::Texture color_;
    gl::Framebuffer target_;
    FrameTimer timer_;
    Errors problems_;
};

} // namespace patina
