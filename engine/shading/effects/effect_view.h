// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>

#include "shading/effects/light_set.h"

namespace patina {

/// Holds what the choice of effects knows of the view beside the scene.
struct EffectView {
    /// Metres from the eye to the farthest point of what is drawn; infinite where nobody knows, so
    /// that nothing is left out because of it.
    double farthest = std::numeric_limits<double>::infinity();

    /// Are the scene's lights that end before what is drawn; null: none.
    std::shared_ptr<const LightSet> unreached = nullptr;

    /// No ray from the eye to what is drawn meets the box that the scene's fog fills.
    bool missesFog = false;

    /// Is the greatest share that the fog has of its density on the mean of a way from the eye to
    /// what is drawn, where it gets thinner with height.
    double fogThickness = 1.0;

    /// An environment's light is fitted, whatever the scene says.
    bool fitsEnvironment = false;

    bool reaches(std::size_t light) const { return unreached == nullptr || !unreached->has(light); }
};

} // namespace patina
