// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include "shading/effects/effect_set.h"

namespace patina {

class SurfaceText;

/// Holds what a program of SurfaceOutput::Buffer writes: place and number of the object, normal and
/// opacity, tangent, then a window of its values (shaders/passes/surface_buffer.glsl).
struct SurfaceBufferLayout {
    static constexpr int outputs = 8;      ///< what every driver offers at once
    static constexpr int window = 5;       ///< values among them
    static constexpr int samples = 4;      ///< of an environment's light: a round
    static constexpr int sampleValues = 2; ///< a direction, and what arrives from it
};

/// Returns the images of a set that change a parameter, by their place in EffectSet::textures.
/// Their results are the first values, in this order; behind them are the samples of an
/// environment's light, then what effects add (`writeBuffer`), then four lights' shares share each.
std::vector<std::size_t> texturedInputs(const EffectSet& set);

/// Returns the first of the values that effects add.
std::size_t firstEffectValue(const EffectSet& set);

/// Returns the first of the values that are lights' shares.
std::size_t firstShare(const EffectSet& set);

/// Returns the first of the values that this effect adds.
template <class Wanted>
std::size_t bufferPlace(const EffectSet& set) {
    std::size_t place = firstEffectValue(set);
    bool isBefore = true;
    set.each([&]<class Effect>(const Effect& effect) {
        isBefore = isBefore && !std::is_same_v<Effect, Wanted>;
        if constexpr (requires { effect.bufferValues(); }) {
            place += isBefore ? static_cast<std::size_t>(effect.bufferValues()) : 0;
        }
    });
    return place;
}

/// Writes what a surface is shaded from, in place of its shading, behind what all programs of
/// surfaces begin with.
void writeBuffer(SurfaceText& text);

} // namespace patina
