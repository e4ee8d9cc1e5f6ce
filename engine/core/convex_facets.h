// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh.h"

namespace patina {

/// Is a plane in object space on which a body ends: all of it has dot(normal, x) <= offset.
struct FacetPlane {
    glm::dvec3 normal{0.0}; ///< unit, outward
    double offset = 0.0;    ///< metres
};

/// Holds the planes of a closed, convex body that ends at few flat facets.
struct ConvexFacets {
    static constexpr std::size_t maxPlanes = 128;
    static constexpr std::size_t maxTriangles = 100'000;

    std::vector<FacetPlane> planes; ///< is empty where the mesh is no such body
    std::string whyNot;             ///< says then why, as the end of a sentence about the mesh
};

/// Finds the planes of a mesh: triangles in one plane, within 1e-5 of the mesh's size, are one
/// facet. The winding of the triangles may be outward or inward. It takes milliseconds, as it ends
/// with the first facet too many and with the first corner that is not behind all planes.
ConvexFacets convexFacetsOf(const MeshView& mesh);

} // namespace patina
