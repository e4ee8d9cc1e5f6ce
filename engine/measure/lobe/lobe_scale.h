// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace patina {

/// Says how a reflectance becomes a length in a plot.
enum class LobeScale { Linear, CubeRoot, Log };

/// Is the number of decades below the largest value that a logarithmic plot shows.
inline constexpr double logDecades = 4.0;

/// Returns the length, 0 .. 1, of a value between 0 and `largest`; 0 where nothing is larger than
/// 0.
double lobeLength(LobeScale scale, double value, double largest);

/// Returns the value that has a length, 0 .. 1: the inverse of lobeLength() above its least value.
double valueAtLength(LobeScale scale, double length, double largest);

/// Returns the word of a scale: "linear", "cube-root", "log"; and the scale of a word.
std::string_view wordOf(LobeScale scale);
std::optional<LobeScale> lobeScaleOf(std::string_view word);

} // namespace patina
