// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/display_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "render/pass/frame_gpu.h"
#include "shading/effects/display_set.h"
#include "shading/effects/effect_key.h"
#include "shading/program/parameter_packer.h"

namespace patina {
namespace {

/// stops; beyond them the whole range of a half float is black or white
constexpr double maxStops = 40.0;

} // namespace

bool DisplayPass::has(const Scene& scene, const Catalog& catalog) const {
    return stages_.contains(EffectKey::ofDisplay(scene, catalog));
}

Result<bool> DisplayPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    const Result<Stage*> made = make(*plan.effects, *gpu.shared.catalog, gpu.shared.programs());
    if (!made) {
        return tl::unexpected(made.error());
    }
    if (!plan.isUnseen) {
        current_ = *made;
        packTone(plan);
    }
    return false;
}

Result<DisplayPass::Stage*> DisplayPass::make(const Scene& scene, const Catalog& catalog,
                                              ProgramCache& cache) {
    const DisplaySet display = displaySet(scene, catalog);
    const std::uint64_t key = keyOf(display);
    if (const auto known = stages_.find(key); known != stages_.end()) {
        return &known->second;
    }
    const auto source = displayProgram(display, catalog);
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found found = cache.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors.front());
    }
    Stage stage{found.program,
                found.program->uniform("exposureFactor"),
                found.program->uniform("toneData"),
                nullptr,
                {}};
    if (display.tone) {
        stage.tone = &display.tone->block();
        stage.layout = layoutOf(*stage.tone);
    }
    return &stages_.emplace(key, std::move(stage)).first->second;
}

/// Packs the values of the scene's tone curve; the defaults where the program has another curve.
void DisplayPass::packTone(const FramePlan& plan) {
    static const Values none;
    static const AccuracyLevels exact;
    tone_.resize(current_->layout.floats / 4);
    if (!tone_.empty()) {
        const BlockValues* part = plan.scene->part(kinds::tone);
        const bool isOfProgram = part != nullptr && part->id == current_->tone->id;
        packInto(tone_, current_->layout, isOfProgram ? part->parameters : none, exact,
                 glm::dmat4(1.0));
    }
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
    if (!tone_.empty()) {
        glUniform4fv(current_->toneUniform, static_cast<int>(tone_.size()),
                     glm::value_ptr(tone_.front()));
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, linear.name());
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

void DisplayPass::forget() {
    stages_.clear();
    current_ = nullptr;
    tone_.clear();
}

} // namespace patina
