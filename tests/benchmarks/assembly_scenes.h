// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina::benchmarks {

/// Limit the time of an assembled program relative to the one written by hand: of each, and of half
/// of them.
inline constexpr double maxAssembled = 1.05;
inline constexpr double maxAssembledMedian = 1.02;

/// Lists the models that have a file in minimal/.
inline constexpr std::array minimalModels{
    "lambert",    "phong", "blinn-phong",     "gaussian", "schlick",      "minnaert",
    "oren-nayar", "gooch", "lommel-seeliger", "toon",     "cook-torrance"};

/// Returns the surroundings of minimal/ in which the model is drawn.
std::vector<std::string> surroundingsOf(const Catalog& catalog, const std::string& model);

/// Returns the scene for which minimal/<surrounding>.frag is written.
Scene sceneOf(const Catalog& catalog, const std::string& model, const std::string& surrounding);

} // namespace patina::benchmarks
