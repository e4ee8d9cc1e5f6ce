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

/// Owns a texture of an environment, whose content can be replaced.
class EnvironmentTexture {
  public:
    /// Uploads a picture, which repeats over its left and right edges and is filtered linearly.
    void fill(const EnvironmentTexels& texels);

    /// Allocates a picture of `size` texels, which fillSome() uploads in steps of some megabytes.
    /// fillSome() returns false when nothing was left to upload.
    void begin(glm::ivec2 size);
    bool fillSome(const EnvironmentTexels& texels);

    /// Uploads a table, whose texels are read without a filter.
    void fill(const EnvironmentTable& table);

    void bind(unsigned unit) const;
    glm::ivec2 size() const { return texture_.size(); }

  private:
    gl::Texture texture_;
    int rows_ = 0; ///< is how many rows of a picture are uploaded
};

/// Owns the small picture of an environment, which the environment's program draws.
class SmallEnvironment {
  public:
    /// Draws the picture and its coarser levels and reads it back. What the program reads must be
    /// bound.
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
    std::vector<glm::vec4> coarser_; ///< holds one level after the other
};

} // namespace patina
