// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "material/material.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/uniform_buffer.h"
#include "shading/program/parameter_packer.h"

namespace patina {

/// Holds the tables of a frame's materials on the GPU, which their blocks read instead of
/// computing. Only materials that read tables have a texture.
class TableStore {
  public:
    /// Makes room for this many materials; allocates nothing when there were as many before.
    void makeRoom(std::size_t materials);

    /// Fills the tables of material `number` and returns true, unless they are the same as before.
    /// Its pipeline must have a program for it. Changes the bound framebuffer, the viewport and the
    /// depth test.
    bool fit(std::size_t number, const Pipeline& pipeline, const Material& material,
             const PackedAround& around);

    /// Deletes the texture of a material that reads no tables any more.
    void drop(std::size_t number);

    /// Binds the table for the pipeline's sampler.
    void bind(std::size_t number) const;

  private:
    struct Tables {
        std::shared_ptr<const gl::Program> program; ///< is the program that filled them; null while
                                                    ///< there are no tables
        std::vector<float> inputs;                  ///< are the values that they were filled from
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    /// Holds the buffers for filling, which materials share.
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
