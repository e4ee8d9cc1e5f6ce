// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/vertex_array.h"
#include "render/lights/environment_image.h"
#include "render/lights/environment_table.h"

namespace patina {

/// Represents a texture of the environment whose content is replaced now and then.
class EnvironmentTexture {
  public:
    /// A picture, which goes on over its left and right edges and is smooth between texels.
    void fill(const EnvironmentTexels& texels);

    /// Does the same bit by bit: room for a picture, and then some megabytes of it for each call,
    /// from where the last one came to. False where there was nothing left of it.
    void begin(glm::ivec2 size);
    bool fillSome(const EnvironmentTexels& texels);

    /// A table, whose texels are read one by one.
    void fill(const EnvironmentTable& table);

    void bind(unsigned unit) const;
    glm::ivec2 size() const { return texture_.size(); }

  private:
    gl::Texture texture_;
    int rows_ = 0; ///< of a picture that are filled
};

/// Holds the small picture of an environment that its own program draws.
class SmallEnvironment {
  public:
    /// Draws it with the program, with what that reads in place, and reads it back; its coarser
    /// levels are made too.
    void draw(const gl::Program& program, glm::ivec2 size);

    std::span<const glm::vec4> radiance() const { return radiance_; }
    void bind(unsigned unit) const;

  private:
    void fit(glm::ivec2 size);
    void fillCoarserLevels();

    gl::Texture texture_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::vector<glm::vec4> radiance_;
    std::vector<glm::vec4> coarser_; ///< one level after the other
};

} // namespace patina
