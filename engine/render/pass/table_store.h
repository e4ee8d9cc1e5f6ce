// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "material/material.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/uniform_buffer.h"

namespace patina {

/// Holds the tables of a frame's materials on the GPU: what their blocks read in place of
/// computing. Only materials that read some have a texture.
class TableStore {
  public:
    /// Makes room for so many materials; allocates nothing when there were as many.
    void makeRoom(std::size_t materials);

    /// Fills the tables of the material of this number, whose pipeline has a program for it, unless
    /// they are the same as before: true if it did. Changes what is drawn to and the depth test.
    bool fit(std::size_t number, const Pipeline& pipeline, const Material& material,
             const glm::dmat4& cameraToWorld);

    /// The material reads none (any more).
    void drop(std::size_t number);

    /// Binds the table for the pipeline's sampler.
    void bind(std::size_t number) const;

  private:
    struct Tables {
        std::shared_ptr<const gl::Program> program; ///< that filled them; null: they are not there
        std::vector<float> inputs;                  ///< and the values it did so from
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    /// Holds what filling needs, once something is to be filled.
    struct Filling {
        UniformBuffer data;
        gl::VertexArray noVertices = gl::VertexArray::create();
    };

    static bool take(Tables& tables, const Pipeline& pipeline, std::span<const glm::vec4> data);
    static void makeTexture(Tables& tables, glm::ivec2 size);

    std::vector<Tables> tables_;
    std::unique_ptr<Filling> filling_;
};

} // namespace patina
