// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/display_pass.h"

#include <utility>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "core/exposure.h"
#include "render/pass/frame_gpu.h"
#include "shading/effects/display_set.h"
#include "shading/effects/effect_key.h"
#include "shading/program/parameter_packer.h"

namespace patina {
bool DisplayPass::has(const Scene& scene, const Catalog& catalog) const {
    return stages_.contains(EffectKey::ofDisplay(scene, catalog));
}

Result<bool> DisplayPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    const Result<Stage*> made =
        make(*frame.plan.effects, *gpu.shared.catalog, gpu.shared.programs());
    if (!made) {
        return tl::unexpected(made.error());
    }
    if (!frame.plan.isUnseen) {
        current_ = *made;
        images_ = &gpu.shared.textures;
        gpu.textures.budget.isWaiting = !pack(*frame.plan.scene) || gpu.textures.budget.isWaiting;
    }
    return false;
}

bool DisplayPass::take(const Scene& scene, const Scene& effects, const Catalog& catalog) {
    const auto known = stages_.find(EffectKey::ofDisplay(effects, catalog));
    if (known == stages_.end() || images_ == nullptr) {
        return false;
    }
    current_ = &known->second;
    pack(scene);
    return true;
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
    auto passes = passPrograms(display, catalog, cache);
    if (!passes) {
        return tl::unexpected(passes.error());
    }
    stage.passes = std::move(*passes);
    return &stages_.emplace(key, std::move(stage)).first->second;
}

/// Packs the values of the scene's tone curve and passes; the defaults where the program has
/// another curve. Returns false while images of passes are being loaded.
bool DisplayPass::pack(const Scene& scene) {
    static const Values none;
    static const AccuracyLevels exact;
    tone_.resize(current_->layout.floats / 4);
    if (!tone_.empty()) {
        const BlockValues* part = scene.part(kinds::tone);
        const bool isOfProgram = part != nullptr && part->id == current_->tone->id;
        packInto(tone_, current_->layout, isOfProgram ? part->parameters : none, exact,
                 glm::dmat4(1.0));
    }
    return chain_.pack(current_->passes, scene, *images_);
}

void DisplayPass::show(const gl::Texture& linear, unsigned framebuffer, double exposure,
                       double share) {
    if (!hasPasses()) {
        chain_.release();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, hasPasses() ? chain_.begin(linear.size()) : framebuffer);
    drawDisplayed(linear, exposure, hasPasses() ? 1.0 : share);
    if (hasPasses()) {
        chain_.draw(current_->passes, framebuffer, share);
    }
}

void DisplayPass::drawDisplayed(const gl::Texture& linear, double exposure, double share) {
    glDisable(GL_DEPTH_TEST);
    setShare(share);
    glDisable(GL_DITHER);
    glDisable(GL_FRAMEBUFFER_SRGB);
    current_->program->use();
    glUniform1f(current_->exposureUniform, static_cast<float>(exposureFactor(exposure)));
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
