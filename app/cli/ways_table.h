// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "measure/approximation/declared_ways.h"
#include "measure/approximation/frame_check.h"

namespace patina {

/// Is what `patina approximate` prints of a search.
struct WaysTable {
    const Block& block; ///< is the one that was searched
    const CheaperWays& ways;
    bool isChecked = false;             ///< on the graphics device
    std::optional<WaysInFrame> inFrame; ///< is empty where nothing was drawn
    double seconds = 0.0;               ///< is how long all of it took
};

nlohmann::json waysJson(const WaysTable& table);
std::string waysText(const WaysTable& table);

nlohmann::json declaredJson(std::span<const DeclaredWay> ways);
std::string declaredText(std::span<const DeclaredWay> ways);

} // namespace patina
