// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace patina {

struct EffectSet;
class SurfaceText;

/// Holds what a program of SurfaceOutput::Buffer writes: place and number of the object, normal and
/// opacity, tangent, then a window of its values (shaders/passes/surface_buffer.glsl).
struct SurfaceBufferLayout {
    static constexpr int outputs = 8;      ///< what every driver offers at once
    static constexpr int window = 5;       ///< values among them
    static constexpr int samples = 4;      ///< of an environment's light: a round
    static constexpr int sampleValues = 2; ///< a direction, and what arrives from it
};

/// The images of a set that change a parameter, by their place in EffectSet::textures. Their
/// results are the first values, in this order; behind them are the samples of an environment's
/// light, then the openness where objects hide light from themselves, then four lights' shares
/// share each.
std::vector<std::size_t> texturedInputs(const EffectSet& set);

/// The value that says how the free directions lie off the mesh's normal (x, y, z), and their share
/// (w); nothing where nothing is hidden.
std::optional<std::size_t> opennessValue(const EffectSet& set);

/// The first of the values that are lights' shares.
std::size_t firstShare(const EffectSet& set);

/// Writes what a surface is shaded from, in place of its shading, behind what all programs of
/// surfaces begin with.
void writeBuffer(SurfaceText& text);

} // namespace patina
