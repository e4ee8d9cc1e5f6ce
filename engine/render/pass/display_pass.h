// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <glm/vec4.hpp>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "core/error.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "render/pass/pass.h"
#include "scene/scene.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Applies exposure, tone mapping and the sRGB curve: from the linear image to a framebuffer.
class DisplayPass : public Pass {
  public:
    /// Compiles (or finds) the program for the scene's exposure and tone curve the first time it
    /// is asked for: one that multiplies by nothing where the exposure is 0. A frame that is not
    /// to be seen leaves what is shown with as it is.
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;

    /// Tells whether prepare() would find it, made before.
    bool has(const Scene& scene, const Catalog& catalog) const;

    bool isPrepared() const { return current_ != nullptr; }

    /// Draws with the program that was prepared last into the bound framebuffer; below a share of
    /// 1 the result is mixed with what is there.
    void show(const gl::Texture& linear, double exposure, double share = 1.0);

    void forget() override;

  private:
    struct Stage {
        std::shared_ptr<const gl::Program> program;
        int exposureUniform = -1;
        int toneUniform = -1;
        const Block* tone = nullptr; ///< null: none
        ParameterLayout layout;      ///< of its values
    };

    Result<Stage*> make(const Scene& scene, const Catalog& catalog, ProgramCache& cache);
    void packTone(const FramePlan& plan);

    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::map<std::uint64_t, Stage> stages_; ///< by EffectKey::ofDisplay()
    const Stage* current_ = nullptr;
    std::vector<glm::vec4> tone_; ///< the values of the curve
};

} // namespace patina
