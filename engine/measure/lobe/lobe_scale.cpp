// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/lobe_scale.h"

#include <algorithm>
#include <cmath>

namespace patina {
namespace {

constexpr LobeScale scales[] = {LobeScale::Linear, LobeScale::CubeRoot, LobeScale::Log};

} // namespace

double lobeLength(LobeScale scale, double value, double largest) {
    if (!(value > 0.0) || !(largest > 0.0)) {
        return 0.0;
    }
    const double share = std::min(value / largest, 1.0);
    switch (scale) {
    case LobeScale::CubeRoot:
        return std::cbrt(share);
    case LobeScale::Log:
        return std::max(1.0 + std::log10(share) / logDecades, 0.0);
    default:
        return share;
    }
}

double valueAtLength(LobeScale scale, double length, double largest) {
    switch (scale) {
    case LobeScale::CubeRoot:
        return largest * length * length * length;
    case LobeScale::Log:
        return largest * std::pow(10.0, logDecades * (length - 1.0));
    default:
        return largest * length;
    }
}

std::string_view wordOf(LobeScale scale) {
    switch (scale) {
    case LobeScale::CubeRoot:
        return "cube-root";
    case LobeScale::Log:
        return "log";
    default:
        return "linear";
    }
}

std::optional<LobeScale> lobeScaleOf(std::string_view word) {
    const auto found =
        std::ranges::find_if(scales, [word](LobeScale scale) { return wordOf(scale) == word; });
    return found == std::end(scales) ? std::nullopt : std::optional(*found);
}

} // namespace patina
