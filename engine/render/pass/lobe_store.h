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
#include "measured/kept_tables.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/uniform_buffer.h"
#include "shading/program/parameter_packer.h"
#include "shading/program/surface_output.h"

namespace patina {

/// Holds the reflectance of a frame's materials, fitted by a matte part and two lobes for each
/// direction of view, in tables on the GPU. Only materials whose light is fitted have a table.
class LobeStore {
  public:
    /// Makes room for this many materials; allocates nothing when there were as many before.
    void makeRoom(std::size_t materials);

    /// Fits the lobes of material `number` and returns true, unless they are the same as before.
    /// Its pipeline must have programs for it, and the table of its measured surface, if any, must
    /// be bound. Changes the bound framebuffer, the viewport and the depth test.
    bool fit(std::size_t number, const Pipeline& pipeline, const Material& material,
             const PackedAround& around, const SharedTable& measured);

    /// Deletes the table of a material that has no lobes any more.
    void drop(std::size_t number);

    /// Binds the table for the pipeline's sampler.
    void bind(std::size_t number) const;

  private:
    struct Lobes {
        std::shared_ptr<const gl::Program> program; ///< is the program of the samples; null while
                                                    ///< there are no lobes
        std::vector<glm::vec4> values;              ///< are the material's packed values at the
                                                    ///< time of the fit
        std::weak_ptr<const HalfDifferenceTable> measured; ///< is what these were read from: a
                                                           ///< file may arrive, or change
        gl::TextureArray table;
        gl::Framebuffer framebuffer;
    };
    /// Holds the intermediate images of a fit, which materials share.
    struct Fitting {
        void makeRoom(const LobeTableShape& shape);

        UniformBuffer data;
        gl::Texture samples;
        gl::Framebuffer sampling;
        gl::TextureArray fitted; ///< holds the fit for each direction of view
        gl::Framebuffer fitting;
        gl::VertexArray noVertices = gl::VertexArray::create();
    };

    static bool take(Lobes& lobes, const Pipeline& pipeline, std::span<const glm::vec4> values,
                     const SharedTable& measured);

    std::vector<Lobes> lobes_;
    std::unique_ptr<Fitting> fitting_;
};

} // namespace patina
