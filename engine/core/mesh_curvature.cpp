// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh_curvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/vectors.h"

namespace patina {
namespace {

/// Is the largest curvature that is kept, in 1/m: a float then holds its square.
constexpr double maxCurvature = 1e12;

std::array<std::uint32_t, 3> cornersOf(const MeshView& mesh, std::size_t triangle) {
    return {mesh.indices[3 * triangle], mesh.indices[3 * triangle + 1],
            mesh.indices[3 * triangle + 2]};
}

VertexCurvature packed(const glm::dmat3& s) {
    return {glm::vec3(s[0][0], s[1][1], s[2][2]), glm::vec3(s[0][1], s[1][2], s[2][0])};
}

glm::dmat3 unpacked(const VertexCurvature& c) {
    return {c.diagonal.x, c.mixed.x, c.mixed.z, c.mixed.x,   c.diagonal.y,
            c.mixed.y,    c.mixed.z, c.mixed.y, c.diagonal.z};
}

void add(VertexCurvature& sum, const VertexCurvature& c, float weight) {
    sum.diagonal += weight * c.diagonal;
    sum.mixed += weight * c.mixed;
}

/// Returns the curvature of a triangle with edges from one corner, along which its normal changes
/// by what is given, in the plane of the triangle; zero where it has no area.
glm::dmat3 bending(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& byU,
                   const glm::dvec3& byV) {
    const glm::dvec3 across = glm::cross(u, v);
    const double area2 = glm::dot(across, across);
    if (!(area2 > 0.0)) {
        return glm::dmat3(0.0);
    }
    // The rows that take an edge to 1 and the other one to 0.
    const glm::dvec3 toU = glm::cross(v, across) / area2;
    const glm::dvec3 toV = glm::cross(across, u) / area2;
    const glm::dmat3 change = glm::outerProduct(byU, toU) + glm::outerProduct(byV, toV);
    const glm::dmat3 inPlane = glm::dmat3(1.0) - glm::outerProduct(across, across) / area2;
    const glm::dmat3 flat = inPlane * change;
    return 0.5 * (flat + glm::transpose(flat));
}

bool isUsable(const glm::dmat3& s) {
    for (int i = 0; i < 3; ++i) {
        if (!isFinite(s[i]) || glm::length(s[i]) > maxCurvature) {
            return false;
        }
    }
    return true;
}

} // namespace

CurvatureFinder::CurvatureFinder(const MeshView& mesh)
    : found_(mesh.vertices.size()), sums_(mesh.vertices.size()) {}

void CurvatureFinder::proceed(const MeshView& mesh, std::size_t items) {
    const bool isOverTriangles = pass_ % 2 == 0;
    const std::size_t count = isOverTriangles ? mesh.indices.size() / 3 : mesh.vertices.size();
    const std::size_t end = std::min(count, next_ + items);
    for (; next_ < end; ++next_) {
        if (!isOverTriangles) {
            finishVertex(mesh, next_);
        } else if (pass_ == 0) {
            addTriangle(mesh, next_);
        } else {
            addNeighbours(mesh, next_);
        }
    }
    if (next_ == count) {
        next_ = 0;
        ++pass_;
    }
}

void CurvatureFinder::addTriangle(const MeshView& mesh, std::size_t triangle) {
    const auto corners = cornersOf(mesh, triangle);
    std::array<glm::dvec3, 3> places;
    std::array<glm::dvec3, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) {
        if (corners[i] >= mesh.vertices.size()) {
            return;
        }
        places[i] = glm::dvec3(mesh.vertices[corners[i]].position);
        normals[i] = glm::dvec3(unitOrZero(mesh.vertices[corners[i]].normal));
    }
    const glm::dvec3 u = places[1] - places[0];
    const glm::dvec3 v = places[2] - places[0];
    const glm::dmat3 s = bending(u, v, normals[1] - normals[0], normals[2] - normals[0]);
    const auto area = static_cast<float>(glm::length(glm::cross(u, v)));
    if (!isUsable(s) || !std::isfinite(area)) {
        return;
    }
    for (const std::uint32_t corner : corners) {
        add(sums_[corner].curvature, packed(s), area);
        sums_[corner].weight += area;
    }
}

void CurvatureFinder::addNeighbours(const MeshView& mesh, std::size_t triangle) {
    const auto corners = cornersOf(mesh, triangle);
    const auto isThere = [&](std::uint32_t corner) { return corner < mesh.vertices.size(); };
    if (!std::ranges::all_of(corners, isThere)) {
        return;
    }
    for (const std::uint32_t corner : corners) {
        for (const std::uint32_t other : corners) {
            add(sums_[corner].curvature, found_[other], 1.0f);
        }
        sums_[corner].weight += 3.0f;
    }
}

/// Takes the mean of what was added, without what lies along the normal.
void CurvatureFinder::finishVertex(const MeshView& mesh, std::size_t vertex) {
    const Sum sum = sums_[vertex];
    sums_[vertex] = Sum();
    if (!(sum.weight > 0.0f)) {
        return;
    }
    const glm::dvec3 n(unitOrZero(mesh.vertices[vertex].normal));
    const glm::dmat3 beside = glm::dmat3(1.0) - glm::outerProduct(n, n);
    const glm::dmat3 s = beside * unpacked(sum.curvature) * beside / double(sum.weight);
    found_[vertex] = isUsable(s) ? packed(s) : VertexCurvature();
}

} // namespace patina
