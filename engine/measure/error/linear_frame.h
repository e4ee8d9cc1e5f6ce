// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace patina {

/// Holds a frame in linear light before exposure, in double precision. Rows from the top.
struct LinearFrame {
    glm::ivec2 size{0};
    std::vector<glm::dvec3> colors;
    std::vector<std::uint8_t> counts; ///< is 1 for a pixel that counts in comparisons, else 0

    friend bool operator==(const LinearFrame&, const LinearFrame&) = default;
};

} // namespace patina
