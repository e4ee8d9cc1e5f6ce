// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gl/framebuffer.h"
#include "measure/time/frame_timer.h"
#include "render/frame/pass_stopwatch.h"
#include "render/renderer.h"

namespace patina {

/// Draws whole frames up to display values and times them. It must be made, used and destroyed with
/// the same context current.
class TimedFrames {
  public:
    /// Holds what frames are drawn with. Meshes and textures must stay valid.
    struct Supplies {
        std::shared_ptr<const Catalog> catalog;
        MeshSource meshes;
        TextureSource textures{}; ///< gives the materials' images; empty: none are shown
    };

    static Result<std::unique_ptr<TimedFrames>> create(Supplies supplies, glm::ivec2 size,
                                                       std::filesystem::path programCache);

    /// Returns the milliseconds of a frame of size(), whatever size the view has. A frame that had
    /// to draw shadow maps, which happens after a change, is drawn again and only then timed.
    double timeOf(const Scene& scene, const View& view);

    /// Draws a frame and returns what each of its passes takes, one after the other.
    std::vector<PassStopwatch::Lap> passesOf(const Scene& scene, const View& view);

    glm::ivec2 size() const { return color_.size(); }
    void resize(glm::ivec2 size);
    std::string method() const { return std::string(timer_.methodText()); }
    Renderer& renderer() { return *renderer_; }
    const MeshSource& meshes() const { return supplies_.meshes; }

    /// Returns what could not be drawn in the last frame that was not complete.
    const Errors& problems() const { return problems_; }

    /// Returns them and forgets them.
    Errors takeProblems() { return std::exchange(problems_, {}); }

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
