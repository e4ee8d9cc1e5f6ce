// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace patina {

/// Holds what the vertex shader reads once per object: attributes 5 to 7 are the rows of the matrix
/// to world space, 8 to 10 those of its inverse transpose (passes/surface.vert).
struct Instance {
    static constexpr unsigned firstAttribute = 5;
    static constexpr unsigned attributes = 6;

    std::array<glm::vec4, 3> world{};
    std::array<glm::vec4, 3> normal{};
};

Instance instanceAt(const glm::dmat4& world);

} // namespace patina
