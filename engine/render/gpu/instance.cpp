// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/instance.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace patina {
namespace {

std::array<glm::vec4, 3> rowsOf(const glm::dmat4& matrix) {
    std::array<glm::vec4, 3> rows;
    for (int row = 0; row < 3; ++row) {
        rows[static_cast<std::size_t>(row)] =
            glm::vec4(matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]);
    }
    return rows;
}

/// Returns the cofactors, which are the inverse transpose times the determinant and exist for every
/// scale, also 0. The largest entry is scaled to 1; the result for a zero matrix is the identity.
glm::dmat4 normalMatrix(const glm::dmat4& world) {
    const glm::dmat3 m(world);
    glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            largest = std::max(largest, std::abs(cofactors[column][row]));
        }
    }
    return largest > 0.0 ? glm::dmat4(cofactors / largest) : glm::dmat4(1.0);
}

} // namespace

Instance instanceAt(const glm::dmat4& world) {
    return {rowsOf(world), rowsOf(normalMatrix(world))};
}

} // namespace patina
