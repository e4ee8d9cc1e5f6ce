// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/display_pass.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <epoxy/gl.h>

#include "render/pass/frame_gpu.h"

namespace patina {
namespace {

/// Beyond this a half float's whole range is black or white.
constexpr double maxStops = 40.0;

std::array<std::string, 3> fragmentFiles(const Scene& scene) {
    const bool none = scene.toneMapping == ToneMapping::None;
    return {none ? "passes/tone_none.glsl" : "passes/tone_neutral.glsl",
            scene.exposure == 0.0 ? "passes/exposed_none.glsl" : "passes/exposed.glsl",
            "passes/display.frag"};
}

} // namespace

std::size_t DisplayPass::indexOf(const Scene& scene) {
    return 2 * static_cast<std::size_t>(scene.toneMapping) + (scene.exposure == 0.0 ? 0 : 1);
}

Result<bool> DisplayPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    if (auto made = make(*plan.effects, *gpu.shared.catalog, gpu.shared.programs()); !made) {
        return tl::unexpected(made.error());
    }
    if (!plan.isUnseen) {
        current_ = &*stages_[indexOf(*plan.effects)];
    }
    return false;
}

Result<void> DisplayPass::make(const Scene& scene, const Catalog& catalog, ProgramCache& cache) {
    std::optional<Stage>& stage = stages_[indexOf(scene)];
    if (!stage) {
        const auto source = passProgram(catalog, "passes/screen.vert", fragmentFiles(scene));
        if (!source) {
            return tl::unexpected(source.error().front());
        }
        const ProgramCache::Found found = cache.get(*source);
        if (!found.program) {
            return tl::unexpected(found.errors.front());
        }
        stage = Stage{found.program, found.program->uniform("exposureFactor")};
    }
    return {};
}

void DisplayPass::show(const gl::Texture& linear, double exposure, double share) {
    glDisable(GL_DEPTH_TEST);
    (share < 1.0 ? glEnable : glDisable)(GL_BLEND);
    glBlendColor(0.0f, 0.0f, 0.0f, static_cast<float>(share));
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glDisable(GL_DITHER);
    glDisable(GL_FRAMEBUFFER_SRGB);
    current_->program->use();
    const double stops = std::clamp(exposure, -maxStops, maxStops);
    glUniform1f(current_->exposureUniform, static_cast<float>(std::exp2(stops)));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, linear.name());
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

void DisplayPass::forget() {
    stages_ = {};
    current_ = nullptr;
}

} // namespace patina
