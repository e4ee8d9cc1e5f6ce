// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace patina {

/// Tells how fine the numbers of a linear picture are.
enum class HdrNumbers {
    Half, ///< 16 bits per channel: a rounding of 0.05 % that nobody sees
    Full, ///< 32 bits, where they are measured
};

/// A channel of light as a picture can hold it: finite, not negative, at most what a half can say.
inline float storable(double channel) {
    return std::isfinite(channel) ? static_cast<float>(std::clamp(channel, 0.0, 65504.0)) : 0.0f;
}

} // namespace patina
