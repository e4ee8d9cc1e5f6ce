// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/image.h"

namespace patina {

/// Says in a few numbers how far a picture is from the right one.
struct PictureDistance {
    double largest = 0.0;      ///< relative error in linear light
    double percentile99 = 0.0; ///< the same, which 99 % of the pixels do not exceed
    double mean = 0.0;         ///< the same
    double flip = 0.0;         ///< Flip, mean
    double similarity = 1.0;   ///< structuralSimilarity() of the lightness

    friend bool operator==(const PictureDistance&, const PictureDistance&) = default;
};

/// `relative`: the error of each pixel in linear light, as FrameDifference has it. `a` and `b`: the
/// right picture and the other one as displays show them, values 0 .. 1. Nothing where it was given
/// up: `isNeedless` is asked every some milliseconds.
std::optional<PictureDistance> pictureDistance(std::vector<float> relative, const Image& a,
                                               const Image& b,
                                               const std::function<bool()>& isNeedless);

} // namespace patina
