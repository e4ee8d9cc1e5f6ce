// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/image.h"

namespace patina {

/// Says how far two frames of one view are apart, in linear light with the exposure in it.
struct FrameDifference {
    glm::ivec2 size{0};
    std::vector<glm::vec3> apart; ///< |A - B| of each channel, 0 or more, rows from the top
    std::vector<float> relative;  ///< the error of B against A, as FrameError has it

    friend bool operator==(const FrameDifference&, const FrameDifference&) = default;
};

/// Compares two linear frames of one size with four channels, as Renderer::capture() gives them. A
/// value that is not finite is apart by the greatest float.
FrameDifference differenceOf(const Image& a, const Image& b);

/// Returns the difference times `gain` as it is shown: sRGB, 8 bits, rows from the top, red first,
/// without gaps.
std::vector<unsigned char> shownDifference(const FrameDifference& difference, double gain);

/// Returns the relative errors in the colours of errorColor(), laid out alike.
std::vector<unsigned char> shownErrors(const FrameDifference& difference);

} // namespace patina
