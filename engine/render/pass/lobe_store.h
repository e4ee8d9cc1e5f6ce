// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "gl/texture_array.h"
#include "gl/vertex_array.h"
#include "material/material.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/uniform_buffer.h"
#include "shading/program/surface_output.h"

namespace patina {

/// Says what the reflectance of a frame's materials was taken apart into, on the GPU: a matte part
/// and two lobes for each viewer. Only materials whose light is fitted have a table.
class LobeStore {
  public:
    /// Makes room for so many materials; allocates nothing when there were as many.
    void makeRoom(std::size_t materials);

    /// Fits the lobes of the material of this number, whose pipeline has programs for it, unless it
    /// is the same as before: true if it did. Changes what is drawn to and the depth test.
    bool fit(std::size_t number, const Pipeline& pipeline, const Material& material,
             const glm::dmat4& cameraToWorld);

    /// The material has none (any more).
    void drop(std::size_t number);

    /// Binds the table for the pipeline's sampler.
    void bind(std::size_t number) const;

  private:
    struct Lobes {
        std::shared_ptr<const gl::Program> program; ///< of the samples; null: there are no lobes
        std::vector<glm::vec4> values;              ///< of the material then
        gl::TextureArray table;
        gl::Framebuffer framebuffer;
    };
    /// Says what fitting needs, once something is to be fitted.
    struct Fitting {
        void makeRoom(const LobeTableShape& shape);

        UniformBuffer data;
        gl::Texture samples;
        gl::Framebuffer sampling;
        gl::TextureArray fitted; ///< of each viewer
        gl::Framebuffer fitting;
        gl::VertexArray noVertices = gl::VertexArray::create();
    };

    static bool take(Lobes& lobes, const Pipeline& pipeline, std::span<const glm::vec4> values);

    std::vector<Lobes> lobes_;
    std::unique_ptr<Fitting> fitting_;
};

} // namespace patina
