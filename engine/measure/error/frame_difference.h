// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/image.h"

namespace patina {

/// Holds the difference of two frames of one view, in linear light after exposure.
struct FrameDifference {
    glm::ivec2 size{0};
    std::vector<glm::vec3> apart; ///< is |A - B| of each channel, rows from the top
    std::vector<float> relative;  ///< is the error of B against A, as in FrameError

    friend bool operator==(const FrameDifference&, const FrameDifference&) = default;
};

/// Compares two linear frames of the same size with four channels, as Renderer::capture() gives
/// them. The difference of a value that is not finite is the greatest float.
FrameDifference differenceOf(const Image& a, const Image& b);

/// Returns the difference times `gain` as a picture: sRGB, 8 bits, rows from the top, red first,
/// without gaps.
std::vector<unsigned char> shownDifference(const FrameDifference& difference, double gain);

/// Returns the relative errors in the colours of errorColor(), in the same layout.
std::vector<unsigned char> shownErrors(const FrameDifference& difference);

} // namespace patina
