// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>

#include <epoxy/gl.h>
#include <glm/trigonometric.hpp>

#include "render/gpu/binding.h"
#include "render/gpu/environment_units.h"
#include "render/gpu/slow_allocation.h"
#include "render/lights/environment_harmonics.h"
#include "scene/environment.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_key.h"
#include "shading/program/parameter_packer.h"

namespace patina {
namespace {

/// pixels of the small picture of an environment without an image
constexpr glm::ivec2 plainSize{256, 128};

/// Values with these roles do not change the brightness in the environment's own space, so the
/// table is kept.
constexpr std::array<std::string_view, 3> otherRoles{roles::rotate, roles::background, roles::blur};

} // namespace

EnvironmentLight::Known& EnvironmentLight::known(std::uint64_t key, const Scene& effects,
                                                 const Catalog& catalog) {
    const auto found = known_.find(key);
    if (found != known_.end()) {
        return found->second;
    }
    const BlockUse use = *sceneEffects(effects, catalog).environment;
    Known made{use, layoutOf(use.block()), {}};
    return known_.emplace(key, std::move(made)).first->second;
}

/// Returns a program of the block; null while it is being built or when it does not compile. Errors
/// are not reported here, since programs of surfaces contain the block too and report them.
const gl::Program* EnvironmentLight::program(Known& known, EnvironmentOutput output,
                                             const Catalog& catalog, ProgramCache& cache) {
    const auto found = known.programs.find(output);
    if (found != known.programs.end()) {
        return found->second.get();
    }
    std::shared_ptr<const gl::Program>& made = known.programs[output];
    if (const auto source = environmentProgram(known.use, catalog, output)) {
        const ProgramCache::Found answer = cache.get(*source);
        if (!answer.isFinal) {
            known.programs.erase(output);
            return nullptr;
        }
        made = answer.program;
    }
    if (made) {
        environment::assignUnits(*made);
    }
    return made.get();
}

void EnvironmentLight::follow(const Subject& subject, const Catalog& catalog, ProgramCache& cache) {
    while (followSome(subject, catalog, cache)) {
    }
}

bool EnvironmentLight::followSome(const Subject& subject, const Catalog& catalog,
                                  ProgramCache& cache) {
    const Scene& effects = subject.effects;
    const Scene& scene = subject.scene;
    isFitted_ = subject.isFitted;
    const std::uint64_t key = EffectKey::ofEnvironment(effects, catalog);
    const bool fits = key != 0 && scene.part(kinds::environment) &&
                      effects.part(kinds::environment)->id == scene.part(kinds::environment)->id;
    current_ = fits ? &known(key, effects, catalog) : nullptr;
    background_ = nullptr;
    if (current_ == nullptr) {
        return false;
    }
    const BlockValues& values = *scene.part(kinds::environment);
    pack(values);
    if (takeImage(subject)) {
        return true;
    }
    if (looksOtherwise() || madeFor_ != current_) {
        madeFor_ = nullptr;
        const int built = cache.builtCount();
        const gl::Program* small = program(*current_, EnvironmentOutput::Small, catalog, cache);
        if (cache.builtCount() == built) {
            makeTable(small);
            madeFor_ = current_;
            blurredFor_ = nullptr;
        }
        return true;
    }
    if (isFitted_ && blurredFor_ != current_ && makeBlurred(catalog, cache)) {
        return true;
    }
    const Backdrop backdrop = backdropOf(values, current_->use.block());
    blur_ = 0.5 * glm::radians(environmentNumber(values, current_->use.block(), roles::blur));
    if (backdrop != Backdrop::Hidden) {
        background_ = program(*current_,
                              backdrop == Backdrop::Sharp ? EnvironmentOutput::SharpBackground
                              : isFitted_                 ? EnvironmentOutput::FittedBackground
                                                          : EnvironmentOutput::BlurredBackground,
                              catalog, cache);
    }
    return false;
}

void EnvironmentLight::pack(const BlockValues& values) {
    static const AccuracyLevels exact;
    const std::size_t vec4s = current_->layout.floats / 4;
    values_.reserve(EnvironmentLayout::fixed + vec4s + EnvironmentLayout::harmonics);
    const std::span<glm::vec4> own = values_.staging().subspan(EnvironmentLayout::fixed, vec4s);
    packInto(own, current_->layout, values.parameters, exact, glm::dmat4(1.0));
    const double turn =
        glm::radians(environmentNumber(values, current_->use.block(), roles::rotate));
    values_.staging()[EnvironmentLayout::turn] =
        glm::vec4(std::cos(turn), std::sin(turn), 0.0f, 1.0f);
    wantedLook_.assign(own.begin(), own.end());
    for (const ParameterField& field : current_->layout.fields) {
        if (field.parameter != nullptr &&
            std::ranges::find(otherRoles, field.parameter->role) != otherRoles.end()) {
            wantedLook_[field.offset / 4][static_cast<int>(field.offset % 4)] = 0.0f;
        }
    }
}

/// Changes the picture or uploads the next part of it. Returns false when all of it is uploaded.
bool EnvironmentLight::takeImage(const Subject& subject) {
    static const std::shared_ptr<const EnvironmentImage> none;
    const auto& image = pictureParameter(current_->use.block()) != nullptr ? subject.image : none;
    if (!picture_ || image != picture_->image) {
        bool isNew = false;
        std::tie(picture_, isNew) = subject.pictures.of(image);
        madeFor_ = nullptr;
        if (isNew && isSlowToAllocate(picture_->whole.size())) {
            return true;
        }
    }
    return picture_->fillSome();
}

bool EnvironmentLight::looksOtherwise() {
    if (look_ == wantedLook_) {
        return false;
    }
    look_.assign(wantedLook_.begin(), wantedLook_.end());
    return true;
}

void EnvironmentLight::makeTable(const gl::Program* program) {
    const bool hasPicture = pictureParameter(current_->use.block()) != nullptr;
    const glm::ivec2 size = program == nullptr ? glm::ivec2(1)
                            : hasPicture       ? picture_->small.size()
                                               : plainSize;
    values_.staging()[EnvironmentLayout::sizes] = glm::vec4(size, 0.0f, 0.0f);
    if (program == nullptr) {
        table_.build(size, {});
    } else {
        upload();
        values_.bind(binding::environment);
        picture_->small.bind(binding::environmentImage);
        baked_.draw(*program, size);
        table_.build(size, baked_.radiance());
        harmonics_ = irradianceHarmonics(size, baked_.radiance());
    }
    tableTexture_.fill(table_);
}

/// Makes the blurred levels, or one of the programs for them. Returns false when it could do
/// neither.
bool EnvironmentLight::makeBlurred(const Catalog& catalog, ProgramCache& cache) {
    const int built = cache.builtCount();
    const gl::Program* sharp = program(*current_, EnvironmentOutput::Octahedral, catalog, cache);
    const gl::Program* matte = program(*current_, EnvironmentOutput::Matte, catalog, cache);
    if (!blurProgram_) {
        if (const auto source = environmentBlurProgram(catalog)) {
            blurProgram_ = cache.get(*source).program;
        }
    }
    if (cache.builtCount() > built) {
        return true;
    }
    if (sharp == nullptr || matte == nullptr || !blurProgram_) {
        return false;
    }
    upload();
    values_.bind(binding::environment);
    picture_->whole.bind(binding::environmentImage);
    blurred_.draw(*sharp, *matte, *blurProgram_);
    blurredFor_ = current_;
    return true;
}

/// Sends the uniform block; the harmonics follow the values of the environment's block.
void EnvironmentLight::upload() {
    const std::size_t end = EnvironmentLayout::fixed + current_->layout.floats / 4;
    for (std::size_t i = 0; i < harmonics_.size(); ++i) {
        values_.staging()[end + i] = glm::vec4(harmonics_[i], 0.0f);
    }
    values_.upload(end + harmonics_.size());
}

void EnvironmentLight::setSamples(const Samples& samples) {
    glm::vec4& turn = values_.staging()[EnvironmentLayout::turn];
    turn.z = static_cast<float>(samples.firstRound);
    const int rounds = (samples.count + roundSamples - 1) / roundSamples;
    turn.w = static_cast<float>(rounds);
    const glm::ivec2 size = table_.size();
    values_.staging()[EnvironmentLayout::sizes] =
        glm::vec4(size, static_cast<float>(samples.count), static_cast<float>(samples.series));
    upload();
}

void EnvironmentLight::bind() const {
    values_.bind(binding::environment);
    tableTexture_.bind(binding::environmentTable);
    picture_->whole.bind(binding::environmentImage);
    if (isFitted_ && blurred_.isThere()) {
        blurred_.bind(binding::environmentBlurred); // has the unit of environmentSmall
    } else {
        baked_.bind(binding::environmentSmall);
    }
}

void EnvironmentLight::forget() {
    known_.clear();
    current_ = nullptr;
    background_ = nullptr;
    madeFor_ = nullptr;
    blurredFor_ = nullptr;
    blurProgram_ = nullptr;
}

} // namespace patina
