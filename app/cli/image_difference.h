// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

namespace patina {

/// Says how far two display images of the same size are apart. Channel values are 0 .. 1.
struct ImageDifference {
    double rootMeanSquare = 0.0; ///< covers all channels but alpha
    double largest = 0.0;
    /// Says which share of the pixels, 0 .. 1, differs by at least one 8-bit step in a channel.
    double changedShare = 0.0;
    double flip = 0.0; ///< is the mean difference that Flip finds, 0 .. 1
};

ImageDifference difference(const Image& a, const Image& b);

} // namespace patina
