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
#include "render/pass/pass_chain.h"
#include "scene/scene.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Draws the linear image into a framebuffer with exposure, tone curve and sRGB encoding, and the
/// passes over it.
class DisplayPass : public Pass {
  public:
    /// Finds or compiles the program for the scene's exposure and tone curve; that for an exposure
    /// of 0 has no multiplication. A frame that nobody sees does not change the program of show().
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;

    /// Returns true when prepare() would not need to compile for this scene.
    bool has(const Scene& scene, const Catalog& catalog) const;

    bool isPrepared() const { return current_ != nullptr; }

    /// Returns true when passes are drawn over the picture.
    bool hasPasses() const { return isPrepared() && !current_->passes.empty(); }

    /// Takes the values of the tone curve and of the passes from a scene, for show() without a new
    /// frame. Returns false where the programs for `effects` are not there; then it does nothing.
    bool take(const Scene& scene, const Scene& effects, const Catalog& catalog);

    /// Draws with the programs that were prepared last into a framebuffer, whose viewport is set.
    /// `exposure` is in stops; a `share` below 1 blends the result with what is there.
    void show(const gl::Texture& linear, unsigned framebuffer, double exposure, double share = 1.0);

    /// Frees the images that passes work in.
    void release() { chain_.release(); }

    void forget() override;

  private:
    struct Stage {
        std::shared_ptr<const gl::Program> program;
        int exposureUniform = -1;
        int toneUniform = -1;
        const Block* tone = nullptr; ///< is null without a tone curve
        ParameterLayout layout;      ///< is that of the tone curve's values
        std::vector<PassPrograms> passes{};
    };

    Result<Stage*> make(const Scene& scene, const Catalog& catalog, ProgramCache& cache);
    bool pack(const Scene& scene);
    void drawDisplayed(const gl::Texture& linear, double exposure, double share);

    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::map<std::uint64_t, Stage> stages_; ///< maps EffectKey::ofDisplay()
    const Stage* current_ = nullptr;
    const GpuTextureStore* images_ = nullptr; ///< is set by prepare()
    std::vector<glm::vec4> tone_;             ///< holds the packed values of the tone curve
    PassChain chain_;
};

} // namespace patina
