// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/vectors.h"
#include "io/vertex_joiner.h"

namespace patina {
namespace {

bool isZero(const glm::vec3& v) {
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

/// Returns the angle whose cosine is `x`, in radians: Abramowitz and Stegun 1964, 4.4.45, |error| <
/// 7e-5. This is enough for a weight, and takes a quarter of the library's time.
float roughAngle(float x) {
    const float c = std::min(std::abs(x), 1.0f);
    const float angle =
        std::sqrt(1.0f - c) * (1.5707288f + c * (-0.2121144f + c * (0.0742610f - 0.0187293f * c)));
    return x < 0.0f ? std::numbers::pi_v<float> - angle : angle;
}

struct Face {
    glm::vec3 normal; ///< unit; zero when even doubles give no direction
    glm::vec3 angles; ///< radians, at the three corners
};

/// Computes the normal in doubles, for slivers whose area is lost in floats.
glm::vec3 preciseNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
}

/// Computes with unit edges: triangles may be as small as 1e-15 or as large as 1e15.
Face faceOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 ab = unitOrZero(b - a);
    const glm::vec3 bc = unitOrZero(c - b);
    const glm::vec3 ca = unitOrZero(a - c);
    const float atA = roughAngle(-glm::dot(ca, ab));
    const float atB = roughAngle(-glm::dot(ab, bc));
    const float atC = std::max(0.0f, std::numbers::pi_v<float> - atA - atB);
    const glm::vec3 normal = glm::cross(ca, ab); // = cross(ab, -ca)
    const float sine = glm::dot(normal, normal);
    // Below a sine of 1e-3 too few digits of the cross product of floats are left.
    return {sine > 1e-6f ? normal / std::sqrt(sine) : preciseNormal(a, b, c), {atA, atB, atC}};
}

/// Sums the weighted face normals at every place.
std::vector<glm::vec3> sumsAtPlaces(const RawMesh& mesh, const Places& places) {
    std::vector<glm::vec3> sums(places.count, glm::vec3(0.0f));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* const corners = &mesh.indices[i];
        const Face face = faceOf(mesh.positions[corners[0]], mesh.positions[corners[1]],
                                 mesh.positions[corners[2]]);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = corners[k];
            const std::uint32_t place = places.ofVertex.empty() ? vertex : places.ofVertex[vertex];
            sums[place] += face.angles[k] * face.normal;
        }
    }
    return sums;
}

/// Gives vertices that still have no normal the one of any face that uses them.
void takeFromFaces(RawMesh& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* const corners = &mesh.indices[i];
        const auto missing = [&](std::uint32_t vertex) { return isZero(mesh.normals[vertex]); };
        if (std::none_of(corners, corners + 3, missing)) {
            continue;
        }
        const Face face = faceOf(mesh.positions[corners[0]], mesh.positions[corners[1]],
                                 mesh.positions[corners[2]]);
        for (int k = 0; k < 3; ++k) {
            if (missing(corners[k])) {
                mesh.normals[corners[k]] =
                    isZero(face.normal) ? glm::vec3(0.0f, 0.0f, 1.0f) : face.normal;
            }
        }
    }
}

} // namespace

void completeNormals(RawMesh& mesh) {
    const Places places = placesOf(mesh);
    mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    for (glm::vec3& n : mesh.normals) {
        n = unitOrZero(n);
    }
    if (std::ranges::none_of(mesh.normals, isZero)) {
        return;
    }
    std::vector<glm::vec3> sums = sumsAtPlaces(mesh, places);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (isZero(mesh.normals[i])) {
            // Below a millionth of a radian the faces cancel and the sum is rounding noise.
            const glm::vec3& sum = sums[places.ofVertex.empty() ? i : places.ofVertex[i]];
            mesh.normals[i] = glm::dot(sum, sum) > 1e-12f ? unitOrZero(sum) : glm::vec3(0.0f);
        }
    }
    takeFromFaces(mesh);
}

} // namespace patina
