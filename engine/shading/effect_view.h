// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace patina {

/// What the choice of effects knows of the view beside the scene.
struct EffectView {
    /// Metres from the eye to the farthest point of what is drawn; infinite where nobody knows, so
    /// that nothing is left out because of it.
    double farthest = std::numeric_limits<double>::infinity();

    /// Bit i: the scene's light i ends before what is drawn. Of lights beyond these nobody knows.
    std::uint64_t unreached = 0;
    static constexpr std::size_t knownLights = 64;

    /// No ray from the eye to what is drawn meets the box that the scene's fog fills.
    bool missesFog = false;

    bool reaches(std::size_t light) const {
        return light >= knownLights || ((unreached >> light) & 1) == 0;
    }

    friend bool operator==(const EffectView&, const EffectView&) = default;
};

} // namespace patina
