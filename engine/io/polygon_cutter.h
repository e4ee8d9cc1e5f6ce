// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "io/polygon.h"
#include "io/raw_mesh.h"

namespace patina {

struct CrossingPoint;

/// Cuts the polygons of a file into triangles that cover each of them exactly, seen along its
/// normal, also where it is concave. A polygon whose outline touches or crosses itself is filled by
/// the nonzero winding rule.
class PolygonCutter {
  public:
    explicit PolygonCutter(RawMesh& mesh) : mesh_(mesh) {}

    /// Appends the triangles of a polygon to the mesh's indices, and vertices where its outline
    /// crosses itself. `corners` are at least three, each below the number of positions.
    void cut(std::span<const std::uint32_t> corners);

  private:
    void cutQuad(std::span<const std::uint32_t> corners);
    void cutFan(std::span<const std::uint32_t> corners);
    bool cutAnyhow(std::span<const std::uint32_t> corners);
    std::uint32_t addVertex(const CrossingPoint& crossing,
                            std::span<const std::uint32_t> vertices, const glm::dvec3& place);

    RawMesh& mesh_;
    Polygon polygon_;
};

} // namespace patina
