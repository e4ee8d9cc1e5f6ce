// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina::benchmarks {

/// What an assembled program may take of the one that is written by hand, and half of them.
inline constexpr double maxAssembled = 1.05;
inline constexpr double maxAssembledMedian = 1.02;

/// Models with a file in minimal/.
inline constexpr std::array minimalModels{
    "lambert",    "phong", "blinn-phong",     "gaussian", "schlick",      "minnaert",
    "oren-nayar", "gooch", "lommel-seeliger", "toon",     "cook-torrance"};

/// What of minimal/ the model is drawn in.
std::vector<std::string> surroundingsOf(const Catalog& catalog, const std::string& model);

/// The scene for which minimal/<surrounding>.frag is written.
Scene sceneOf(const Catalog& catalog, const std::string& model, const std::string& surrounding);

} // namespace patina::benchmarks
