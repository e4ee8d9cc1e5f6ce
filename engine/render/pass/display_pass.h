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

/// Draws the linear image into a framebuffer with exposure, tone curve and sRGB encoding.
class DisplayPass : public Pass {
  public:
    /// Finds or compiles the program for the scene's exposure and tone curve; that for an exposure
    /// of 0 has no multiplication. A frame that nobody sees does not change the program of show().
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;

    /// Returns true when prepare() would not need to compile for this scene.
    bool has(const Scene& scene, const Catalog& catalog) const;

    bool isPrepared() const { return current_ != nullptr; }

    /// Draws with the program that was prepared last into the bound framebuffer. `exposure` is in
    /// stops; a `share` below 1 blends the result with what is there.
    void show(const gl::Texture& linear, double exposure, double share = 1.0);

    void forget() override;

  private:
    struct Stage {
        std::shared_ptr<const gl::Program> program;
        int exposureUniform = -1;
        int toneUniform = -1;
        const Block* tone = nullptr; ///< is null without a tone curve
        ParameterLayout layout;      ///< is that of the tone curve's values
    };

    Result<Stage*> make(const Scene& scene, const Catalog& catalog, ProgramCache& cache);
    void packTone(const FramePlan& plan);

    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::map<std::uint64_t, Stage> stages_; ///< maps EffectKey::ofDisplay()
    const Stage* current_ = nullptr;
    std::vector<glm::vec4> tone_; ///< holds the packed values of the tone curve
};

} // namespace patina
