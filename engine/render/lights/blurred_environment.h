// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"

namespace patina {

/// Holds an environment convolved with von Mises-Fisher lobes: an octahedral picture in levels of
/// increasing blur, and one for matte surfaces (shaders/passes/environment_out_of_focus.glsl).
class BlurredEnvironment {
  public:
    /// Draws all levels. `sharp` and `matte` are programs of EnvironmentOutput::Octahedral and
    /// Matte, whose data must be bound; `blur` is one of environmentBlurProgram(). Leaves another
    /// framebuffer and viewport.
    void draw(const gl::Program& sharp, const gl::Program& matte, const gl::Program& blur);

    bool isThere() const { return levels_.size().x > 0; }
    void bind(unsigned unit) const;

  private:
    void makeRoom();
    void drawAt(glm::ivec2 origin, int width);

    gl::Texture levels_; ///< holds all levels in one image
    gl::Texture drawn_;  ///< holds one level before it is copied into levels_
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
};

} // namespace patina
