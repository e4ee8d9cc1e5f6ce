// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/raw_mesh.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/color.h"

namespace patina {
namespace {

glm::vec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

/// Returns the cofactor matrix: the inverse transpose times the determinant, defined also when the
/// matrix is singular. Its sign is corrected so that a mirrored surface keeps its outside.
glm::dmat3 normalMatrix(const glm::dmat3& m, bool mirrors) {
    const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                              glm::cross(m[0], m[1]));
    return mirrors ? -1.0 * cofactor : cofactor;
}

} // namespace

void RawMesh::transform(const glm::dmat4& matrix, std::size_t first, std::size_t firstIndex) {
    if (matrix == glm::dmat4(1.0)) {
        return;
    }
    const glm::dmat3 linear(matrix);
    const bool mirrors = glm::determinant(linear) < 0.0;
    const glm::dmat3 forNormals = normalMatrix(linear, mirrors);
    for (std::size_t i = first; i < positions.size(); ++i) {
        positions[i] = glm::vec3(matrix * glm::dvec4(positions[i], 1.0));
    }
    for (std::size_t i = first; i < normals.size(); ++i) {
        normals[i] = unitOrZero(forNormals * glm::dvec3(normals[i]));
    }
    for (std::size_t i = first; i < tangents.size(); ++i) {
        const glm::vec4 t = tangents[i];
        tangents[i] = glm::vec4(unitOrZero(linear * glm::dvec3(t)), mirrors ? -t.w : t.w);
    }
    for (std::size_t i = firstIndex; mirrors && i + 2 < indices.size(); i += 3) {
        std::swap(indices[i + 1], indices[i + 2]);
    }
}

void RawMesh::setMaterial(std::size_t firstIndex, std::uint32_t material) {
    materialOf.resize(firstIndex / 3, noMaterial);
    materialOf.resize(indices.size() / 3, material);
}

void RawMesh::decodeColors() {
    for (glm::vec4& color : colors) {
        color = glm::vec4(glm::vec3(srgbDecoded(glm::dvec3(color))), color.w);
    }
}

void RawMesh::padAttributes() {
    if (!normals.empty()) {
        normals.resize(positions.size(), glm::vec3(0.0f));
    }
    if (!tangents.empty()) {
        tangents.resize(positions.size(), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    }
    if (!uvs.empty()) {
        uvs.resize(positions.size(), glm::vec2(0.0f));
    }
    if (!colors.empty()) {
        colors.resize(positions.size(), glm::vec4(1.0f));
    }
}

std::vector<glm::vec4> withAlpha(const std::vector<glm::vec3>& colors) {
    std::vector<glm::vec4> opaque;
    opaque.reserve(colors.size());
    for (const glm::vec3& color : colors) {
        opaque.emplace_back(color, 1.0f);
    }
    return opaque;
}

} // namespace patina
