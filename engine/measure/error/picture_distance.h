// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "core/image.h"

namespace patina {

/// Holds the difference of a picture from the right one in a few numbers.
struct PictureDistance {
    double largest = 0.0;      ///< is a relative error in linear light
    double percentile99 = 0.0; ///< is the relative error that 99 % of the pixels keep
    double mean = 0.0;         ///< is a relative error
    double flip = 0.0;         ///< is the mean FLIP difference, 0 .. 1
    double similarity = 1.0;   ///< is the structuralSimilarity() of the luma

    friend bool operator==(const PictureDistance&, const PictureDistance&) = default;
};

/// Returns the first three channels of each pixel, row by row.
std::vector<glm::dvec3> displayColors(const Image& image);

/// Compares the display values 0 .. 1 of the ground truth `a` and of `b`. `relative` is the error
/// of each pixel in linear light, as in FrameDifference. Calls `isNeedless` every 20 milliseconds
/// or so, and returns nothing once that is true.
std::optional<PictureDistance> pictureDistance(std::vector<float> relative, const Image& a,
                                               const Image& b,
                                               const std::function<bool()>& isNeedless);

} // namespace patina
