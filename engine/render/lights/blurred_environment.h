// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/cube_map.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/vertex_array.h"

namespace patina {

/// An environment as lobes of von Mises' and Fisher's form see it: a cube map whose levels are more
/// and more out of focus, by kappa 4096, 1024, ... 1/4 (shaders/passes/environment_fitted.glsl).
class BlurredEnvironment {
  public:
    /// Draws it with programs of EnvironmentOutput::Faces, whose data are bound, and of
    /// environmentBlurProgram(). Changes what is drawn to.
    void draw(const gl::Program& faces, const gl::Program& blur);

    bool isThere() const { return map_.width() > 0; }
    void bind(unsigned unit) const { map_.bind(unit); }

  private:
    void drawLevel(const gl::Program& program, int level);

    gl::CubeMap map_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
};

} // namespace patina
