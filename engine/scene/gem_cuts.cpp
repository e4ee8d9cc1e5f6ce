// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/gem_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace patina {
namespace {

using std::numbers::pi;

/// Corners of different facets that are closer than this are one.
constexpr double sameCorner = 1e-7;

/// Is a half of space: all x with dot(normal, x) <= offset.
struct HalfSpace {
    glm::dvec3 normal; ///< unit
    double offset = 0.0;
};

HalfSpace through(const glm::dvec3& normal, const glm::dvec3& x) {
    const glm::dvec3 n = glm::normalize(normal);
    return {n, glm::dot(n, x)};
}

/// Returns the half that has the origin and ends at three points.
HalfSpace through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 n = glm::cross(b - a, c - a);
    return through(glm::dot(n, a) < 0.0 ? -n : n, a);
}

using Polygon = std::vector<glm::dvec3>;

/// Returns what of a polygon is within a half of space.
Polygon clipped(const Polygon& polygon, const HalfSpace& half) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double before = half.offset - glm::dot(half.normal, a);
        const double after = half.offset - glm::dot(half.normal, b);
        if (before >= 0.0) {
            kept.push_back(a);
        }
        if ((before < 0.0) != (after < 0.0)) {
            kept.push_back(glm::mix(a, b, before / (before - after)));
        }
    }
    return kept;
}

/// Is where several planes meet, taken as one place however rounding moved it.
class Corners {
  public:
    glm::dvec3 at(const glm::dvec3& x) {
        const auto found = std::ranges::find_if(known_, [&x](const glm::dvec3& corner) {
            return glm::distance(corner, x) < sameCorner;
        });
        return found == known_.end() ? known_.emplace_back(x) : *found;
    }

  private:
    std::vector<glm::dvec3> known_;
};

/// Returns a level direction in the plane of a facet, and +x for a level one.
glm::dvec3 levelIn(const glm::dvec3& normal) {
    const glm::dvec3 level(normal.z, 0.0, -normal.x);
    return glm::length(level) > 1e-6 ? glm::normalize(level) : glm::dvec3(1.0, 0.0, 0.0);
}

/// Returns the facet of a body that is cut by all planes.
Polygon facetOf(const std::vector<HalfSpace>& cuts, std::size_t index, Corners& corners) {
    constexpr double far = 10.0;
    const glm::dvec3 n = cuts[index].normal;
    const glm::dvec3 t = levelIn(n);
    const glm::dvec3 b = glm::cross(n, t);
    const glm::dvec3 middle = cuts[index].offset * n;
    Polygon facet{middle - far * (t + b), middle + far * (t - b), middle + far * (t + b),
                  middle - far * (t - b)};
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (i != index) {
            facet = clipped(facet, cuts[i]);
        }
    }
    Polygon joined;
    for (const glm::dvec3& x : facet) {
        const glm::dvec3 corner = corners.at(x);
        if (joined.empty() || (joined.back() != corner && joined.front() != corner)) {
            joined.push_back(corner);
        }
    }
    return joined;
}

void addFacet(Mesh& mesh, const Polygon& facet, const glm::dvec3& n, double middle) {
    const glm::dvec3 t = levelIn(n);
    const glm::dvec3 b = glm::cross(n, t);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::dvec3& corner : facet) {
        const glm::dvec3 x = corner - glm::dvec3(0.0, middle, 0.0);
        const glm::dvec2 uv = 0.5 + 0.5 * glm::dvec2(glm::dot(x, t), glm::dot(x, b));
        mesh.vertices.push_back({x, n, glm::vec4(t, 1.0f), uv});
    }
    for (std::uint32_t i = 2; i < facet.size(); ++i) {
        mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
    }
}

/// Returns the body within all planes, a facet for each, the middle of its height at the origin.
Mesh cut(const std::vector<HalfSpace>& cuts) {
    Corners corners;
    std::vector<Polygon> facets;
    double low = 0.0;
    double high = 0.0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        for (const glm::dvec3& x : facets.emplace_back(facetOf(cuts, i, corners))) {
            low = std::min(low, x.y);
            high = std::max(high, x.y);
        }
    }
    Mesh mesh;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        addFacet(mesh, facets[i], cuts[i].normal, 0.5 * (low + high));
    }
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

glm::dvec3 around(double azimuth, double radius, double height) {
    return {radius * std::cos(azimuth), height, radius * std::sin(azimuth)};
}

/// Adds the facets above the girdle of a brilliant, or those below it at a `side` of -1: eight
/// mains at an angle and two halves between each, of which pairs end on the line between the mains
/// at `halfEnd` from the axis.
void addHalf(std::vector<HalfSpace>& cuts, double side, double girdle, double angle,
             double halfEnd) {
    constexpr double eighth = pi / 4.0;
    const double steepness = std::tan(angle);
    const double between = halfEnd * std::cos(0.5 * eighth);
    const double height = girdle + (1.0 - between) * steepness;
    for (int i = 0; i < 8; ++i) {
        const double azimuth = i * eighth;
        const glm::dvec3 rim = around(azimuth, 1.0, side * girdle);
        cuts.push_back(through(around(azimuth, std::sin(angle), side * std::cos(angle)), rim));
        for (const double next : {-0.5, 0.5}) {
            const double middle = azimuth + next * eighth;
            cuts.push_back(through(rim, around(middle, 1.0, side * girdle),
                                   around(middle, halfEnd, side * height)));
        }
    }
}

} // namespace

Mesh roundBrilliant() {
    constexpr double eighth = pi / 4.0;
    constexpr double table = 0.53;
    constexpr double girdle = 0.027; // half its thickness where it is thickest
    constexpr int girdleFacets = 32;
    const double crown = glm::radians(34.5);
    const double tableHeight = girdle + (1.0 - table) * std::tan(crown);
    const double tableEdge = table * std::cos(0.5 * eighth);
    const double starEnd = tableEdge + 0.5 * (1.0 - tableEdge);
    const double starHeight = girdle + (1.0 - starEnd * std::cos(0.5 * eighth)) * std::tan(crown);
    std::vector<HalfSpace> cuts{{{0.0, 1.0, 0.0}, tableHeight}};
    for (int i = 0; i < 8; ++i) {
        cuts.push_back(through(around(i * eighth, table, tableHeight),
                               around((i + 1) * eighth, table, tableHeight),
                               around((i + 0.5) * eighth, starEnd, starHeight)));
    }
    addHalf(cuts, 1.0, girdle, crown, starEnd);
    addHalf(cuts, -1.0, girdle, glm::radians(40.75), 1.0 - 0.77);
    for (int i = 0; i < girdleFacets; ++i) {
        const double azimuth = (i + 0.5) * 2.0 * pi / girdleFacets;
        cuts.push_back({around(azimuth, 1.0, 0.0), std::cos(pi / girdleFacets)});
    }
    return cut(cuts);
}

Mesh emeraldCut() {
    constexpr double halfLength = 1.0;
    constexpr double halfWidth = 0.72;
    constexpr double cornerCut = 0.45; // metres less than an uncut corner, along both sides
    constexpr double girdle = 0.02;
    constexpr int steps = 3;
    constexpr double crownStep = 0.09; // metres inwards
    constexpr double pavilionStep = halfWidth / steps;
    constexpr std::array<double, steps> crownAngles{46.0, 38.0, 30.0};
    constexpr std::array<double, steps> pavilionAngles{52.0, 43.0, 34.0};
    const auto distance = [](int side) {
        const double corner = (halfLength + halfWidth - cornerCut) / std::numbers::sqrt2;
        return side % 2 != 0 ? corner : side % 4 == 0 ? halfLength : halfWidth;
    };
    std::vector<HalfSpace> cuts;
    double table = girdle;
    for (int side = 0; side < 8; ++side) {
        const double azimuth = side * pi / 4.0;
        cuts.push_back({around(azimuth, 1.0, 0.0), distance(side)});
        const auto addSteps = [&](const std::array<double, steps>& angles, double inwards,
                                  double sign) {
            double height = girdle;
            for (int i = 0; i < steps; ++i) {
                const double angle = glm::radians(angles[static_cast<std::size_t>(i)]);
                cuts.push_back(
                    through(around(azimuth, std::sin(angle), sign * std::cos(angle)),
                            around(azimuth, distance(side) - i * inwards, sign * height)));
                height += inwards * std::tan(angle);
            }
            return height;
        };
        table = addSteps(crownAngles, crownStep, 1.0);
        addSteps(pavilionAngles, pavilionStep, -1.0);
    }
    cuts.push_back({{0.0, 1.0, 0.0}, table});
    return cut(cuts);
}

} // namespace patina
