// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <glm/vec2.hpp>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/target_texture.h"
#include "render/pass/pass.h"

namespace patina {

/// Draws the normal, depth and number of the object at the centre of each pixel, where a pass over
/// the picture reads them. What is transparent counts like what is solid; the ground is not there,
/// and neither are images that cut holes. Without such a pass it takes no memory and no time.
class DepthNormalPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "depth and normals"; }
    void forget() override { program_.reset(); }

    /// Returns true where the images of the last frame are there.
    bool isThere() const { return images_ != nullptr; }

    /// Binds the images for a program of a pass, to texture units of their own.
    void bind() const;
    static void nameUnits(const gl::Program& program);

    /// Frees the images.
    void release() { images_.reset(); }

  private:
    struct Images {
        glm::ivec2 size{0};
        gl::TargetTexture normals; ///< x to the right, y up, z to the eye
        gl::TargetTexture depths;  ///< x: metres from the eye's plane; y: the number
        gl::Renderbuffer nearest;
        gl::Framebuffer framebuffer;
    };

    Result<void> makeProgram(FrameGpu& gpu);
    Result<void> fit(glm::ivec2 size);

    std::shared_ptr<const gl::Program> program_;
    std::unique_ptr<Images> images_; ///< is null while no pass reads them
    bool isDone_ = false;
};

} // namespace patina
