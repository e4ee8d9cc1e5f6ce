// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace patina {

/// What the choice of effects knows of the view beside the scene.
struct EffectView {
    /// Metres from the eye to the farthest point of what is drawn; infinite where nobody knows, so
    /// that nothing is left out because of it.
    double farthest = std::numeric_limits<double>::infinity();

    friend bool operator==(const EffectView&, const EffectView&) = default;
};

} // namespace patina
