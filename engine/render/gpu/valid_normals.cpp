// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/valid_normals.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/vectors.h"

namespace patina {
namespace {

constexpr float shortestSquared = 0.25f;
constexpr float longestSquared = 4.0f;

bool isValid(const Vertex& vertex) {
    const float squared = glm::dot(vertex.normal, vertex.normal);
    const bool isUsual = squared >= shortestSquared && squared <= longestSquared;
    return isUsual || vertex.normal == glm::vec3(0.0f); // neither holds for what is no number
}

} // namespace

bool haveValidNormals(std::span<const Vertex> vertices) {
    return std::ranges::all_of(vertices, isValid);
}

std::vector<Vertex> withValidNormals(std::span<const Vertex> vertices) {
    std::vector<Vertex> valid(vertices.begin(), vertices.end());
    for (Vertex& vertex : valid) {
        if (!isValid(vertex)) {
            vertex.normal = unitOrZero(vertex.normal);
        }
    }
    return valid;
}

} // namespace patina
