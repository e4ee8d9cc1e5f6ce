// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Says how the edges in a frame were looked for: what the device did, not what was asked for.
struct PixelSampling {
    int samples = 1;  ///< of each pixel that is drawn
    int fineness = 1; ///< pixels that are drawn for one of the picture, along each side

    friend bool operator==(const PixelSampling&, const PixelSampling&) = default;
};

} // namespace patina
