// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"

namespace patina {

/// Represents an environment as lobes of von Mises' and Fisher's form see it: an octahedral picture
/// whose levels are more and more out of focus, and what matte surfaces show
/// (shaders/passes/environment_out_of_focus.glsl).
class BlurredEnvironment {
  public:
    /// Draws it with programs of EnvironmentOutput::Octahedral and Matte, whose data are bound, and
    /// of environmentBlurProgram(). Changes what is drawn to.
    void draw(const gl::Program& sharp, const gl::Program& matte, const gl::Program& blur);

    bool isThere() const { return levels_.size().x > 0; }
    void bind(unsigned unit) const;

  private:
    void makeRoom();
    void drawAt(glm::ivec2 origin, int width);

    gl::Texture levels_; ///< beside and upon each other
    gl::Texture drawn_;  ///< a level, before it is copied to its place
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
};

} // namespace patina
