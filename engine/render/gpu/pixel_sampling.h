// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Says how a frame was antialiased: what the device did, not what was asked for.
struct PixelSampling {
    int samples = 1;  ///< counts for each pixel that is drawn
    int fineness = 1; ///< is the number of drawn pixels per pixel of the picture, along each side

    friend bool operator==(const PixelSampling&, const PixelSampling&) = default;
};

} // namespace patina
