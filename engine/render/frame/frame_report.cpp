// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that says what a frame was made of.
#include <algorithm>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "render/frame/frame_drawer.h"

namespace patina {
namespace {

/// Canonical order: the object's own effects as they come, each once.
void addOnce(std::vector<std::string>& effects, const std::string& effect) {
    if (std::find(effects.begin(), effects.end(), effect) == effects.end()) {
        effects.push_back(effect);
    }
}

void addOnce(Errors& errors, const Error& error) {
    if (std::find(errors.begin(), errors.end(), error) == errors.end()) {
        errors.push_back(error);
    }
}

} // namespace

void FrameDrawer::noteProgram(const void* program) {
    if ((programs_.empty() || programs_.back() != program) &&
        std::find(programs_.begin(), programs_.end(), program) == programs_.end()) {
        programs_.push_back(program);
    }
}

void FrameDrawer::describe() {
    programs_.clear();
    for (const DrawBatch& batch : list_.batches()) {
        const DrawMaterial& material = materials_[batch.material];
        noteProgram(material.pipeline->program.get());
        if (material.hasLines()) {
            noteProgram(material.pipeline->outlineProgram.get());
        }
    }
    report_.programs = static_cast<int>(programs_.size());
    if (sources_ == described_ && lostLights_ + shadows_.lost() == describedLost_ &&
        shadowError_ == describedShadowError_) {
        return;
    }
    describeEffects();
    described_ = sources_;
    describedLost_ = lostLights_ + shadows_.lost();
    describedShadowError_ = shadowError_;
}

void FrameDrawer::describeEffects() {
    report_.effects.clear();
    report_.messages.clear();
    report_.warnings = 0;
    for (const DrawMaterial& used : materials_) {
        const Material& material = effects_->objects[used.object].material;
        const std::uint64_t key = EffectKey::ofMaterial(material, *catalog_);
        const PipelineStore::Surroundings around = surroundings(used.missing);
        for (const Error& error : pipelines_.get(material, key, around).errors) {
            addOnce(report_.messages, error);
        }
        if (used.pipeline) {
            for (const EffectLine& line : effectLines(used.pipeline->effects)) {
                addOnce(report_.effects, line.effect);
            }
        }
    }
    if (ground_.isSeen && ground_.pipeline) {
        for (const EffectLine& line : effectLines(ground_.pipeline->effects)) {
            addOnce(report_.effects, line.effect);
        }
    }
    addLost();
}

void FrameDrawer::addLost() {
    const auto add = [this](Error error) {
        ++report_.warnings;
        report_.messages.push_back(std::move(error));
    };
    if (lostLights_ > 0) {
        add({{}, 0, 0, fmt::format("{} lights are left out because the graphics card's memory for "
                                   "lights is full", lostLights_), {}});
    }
    if (shadows_.lost() > 0) {
        add({{}, 0, 0, fmt::format("{} lights have no shadows because there is no room for more",
                                   shadows_.lost()), {}});
    }
    if (shadowError_) {
        add(*shadowError_);
    }
}

void FrameDrawer::show(const Scene& scene, const View& view, unsigned framebuffer) {
    if (hasFailed_) {
        return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.size.x, view.size.y);
    display_.draw(environment_.hasPicture() ? environment_.picture() : target_.resolved(),
                  scene.exposure);
    leaveState();
}

void FrameDrawer::leaveState() {
    glBindVertexArray(0);
    glUseProgram(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDepthFunc(GL_LESS);
}

/// A driver may keep what was drawn with last until something else is: one pixel takes its place.
void FrameDrawer::releaseTargets() {
    transparency_.leaveOut();
    refraction_.reset();
    if (!display_.isPrepared() || !target_.fit(glm::ivec2(1), 1, false)) {
        target_ = HdrTarget();
        return;
    }
    target_.bind();
    display_.draw(target_.resolved(), 0.0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    leaveState();
}

} // namespace patina
