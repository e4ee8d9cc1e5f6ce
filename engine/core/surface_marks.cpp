// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace patina {
namespace {

/// Is the distance between n marks on an area, in units of sqrt(area / n). Circles of that distance
/// that lie as close as they can would have 1.07.
constexpr double spacing = 0.62;

/// Is how many places are tried before the farthest of them is taken.
constexpr int maxMisses = 48;

/// Is the least difference of normals, in radians, that is no rounding of one and the same.
constexpr float minTurn = 1e-5f;

std::uint64_t mixedBits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

glm::dvec3 cornerOf(const MeshView& mesh, std::size_t corner) {
    return mesh.vertices[mesh.indices[corner]].position;
}

/// Returns the vector across a triangle, as long as twice its area.
glm::dvec3 acrossTriangle(const MeshView& mesh, std::size_t triangle) {
    const glm::dvec3 a = cornerOf(mesh, 3 * triangle);
    return glm::cross(cornerOf(mesh, 3 * triangle + 1) - a, cornerOf(mesh, 3 * triangle + 2) - a);
}

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& other) {
    const float length = glm::length(v);
    return length > 1e-6f && std::isfinite(length) ? v / length : other;
}

/// Returns how fast the normal turns outwards from one corner to another, in radians for each
/// metre, or inwards below 0; 0 where that is not a number, or normals differ by rounding alone.
float turnOf(const Vertex& from, const Vertex& to) {
    const glm::vec3 way = to.position - from.position;
    const glm::vec3 change = to.normal - from.normal;
    const float turn = glm::dot(change, way) / glm::dot(way, way);
    return std::isfinite(turn) && glm::dot(change, change) > minTurn * minTurn ? turn : 0.0f;
}

} // namespace

std::size_t SurfaceMarks::CellHash::operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int32_t part : cell) {
        hash = mixedBits(hash + 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(part));
    }
    return static_cast<std::size_t>(hash);
}

SurfaceMarks::SurfaceMarks(const MeshView& mesh)
    : triangles_(mesh.indices.size() / 3),
      origin_(mesh.bounds.empty() ? glm::vec3(0.0f) : mesh.bounds.lower) {
    areas_.reserve(triangles_);
}

void SurfaceMarks::proceed(const MeshView& mesh, std::size_t items, std::size_t count) {
    for (; items > 0 && !isMeasured(); --items) {
        measure(mesh, areas_.size());
    }
    if (!isMeasured() || !(area() > 0.0)) {
        return;
    }
    const std::size_t last = std::min(count, maxCount);
    for (; items > 0 && marks_.size() < last; --items) {
        throwDart(mesh);
    }
}

/// A triangle with a corner that is not finite has no area.
void SurfaceMarks::measure(const MeshView& mesh, std::size_t triangle) {
    const double own = 0.5 * glm::length(acrossTriangle(mesh, triangle));
    areas_.push_back(area() + (std::isfinite(own) ? own : 0.0));
}

/// Returns a number of the series, 0 <= x < 1 (SplitMix64: Steele, Lea and Flood 2014).
double SurfaceMarks::nextNumber() {
    return static_cast<double>(mixedBits(++numbers_ * 0x9e3779b97f4a7c15u) >> 11) * 0x1p-53;
}

/// Returns a place that is equally likely everywhere on the surface.
SurfaceMark SurfaceMarks::randomPlace(const MeshView& mesh) {
    const auto found = std::ranges::upper_bound(areas_, nextNumber() * area());
    const auto triangle =
        static_cast<std::size_t>(std::min(found, areas_.end() - 1) - areas_.begin());
    const auto root = static_cast<float>(std::sqrt(nextNumber()));
    const auto share = static_cast<float>(nextNumber());
    const std::array<float, 3> weights{1.0f - root, root * (1.0f - share), root * share};
    SurfaceMark mark;
    mark.at = {glm::vec3(0.0f), glm::vec3(0.0f), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
               glm::vec2(0.0f)};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vertex& corner = mesh.vertices[mesh.indices[3 * triangle + i]];
        mark.at.position += weights[i] * corner.position;
        mark.at.normal += weights[i] * corner.normal;
        mark.at.tangent += glm::vec4(weights[i] * glm::vec3(corner.tangent), 0.0f);
        mark.at.uv += weights[i] * corner.uv;
        mark.at.tangent.w = corner.tangent.w;
        const Vertex& next = mesh.vertices[mesh.indices[3 * triangle + (i + 1) % 3]];
        const float turn = turnOf(corner, next);
        mark.bend = std::abs(turn) > std::abs(mark.bend) ? turn : mark.bend;
    }
    const glm::vec3 face(glm::normalize(acrossTriangle(mesh, triangle)));
    mark.at.normal = unitOr(mark.at.normal, face);
    mark.at.tangent =
        glm::vec4(unitOr(glm::vec3(mark.at.tangent), glm::vec3(0.0f)), mark.at.tangent.w);
    return mark;
}

SurfaceMarks::Cell SurfaceMarks::cellOf(const glm::vec3& place) const {
    const glm::dvec3 at = glm::dvec3(place - origin_) / cellSize_;
    const auto whole = [](double x) {
        return static_cast<std::int32_t>(std::clamp(std::floor(x), -1e9, 1e9));
    };
    return {whole(at.x), whole(at.y), whole(at.z)};
}

/// Returns the distance to the nearest mark on the same side of the surface, where that is less
/// than a cell is wide.
double SurfaceMarks::nearest(const SurfaceMark& place) const {
    double nearest2 = std::numeric_limits<double>::max();
    const Cell middle = cellOf(place.at.position);
    for (std::int32_t i = 0; i < 27; ++i) {
        const auto found =
            cells_.find({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1});
        std::uint32_t next = found == cells_.end() ? 0 : found->second;
        for (; next != 0; next = before_[next - 1]) {
            const Vertex& other = marks_[next - 1].at;
            const glm::dvec3 way = glm::dvec3(place.at.position) - glm::dvec3(other.position);
            if (glm::dot(place.at.normal, other.normal) > 0.0f) {
                nearest2 = std::min(nearest2, glm::dot(way, way));
            }
        }
    }
    return std::sqrt(nearest2);
}

void SurfaceMarks::throwDart(const MeshView& mesh) {
    const double apart = spacing * std::sqrt(area() / double(marks_.size() + 1));
    if (cellSize_ == 0.0 || apart < 0.5 * cellSize_) {
        cellSize_ = apart;
        refineCells();
    }
    const SurfaceMark place = randomPlace(mesh);
    const double distance = nearest(place);
    if (distance > bestDistance_) {
        bestDistance_ = distance;
        best_ = place;
    }
    if (distance >= apart || ++misses_ >= maxMisses) {
        add(best_);
    }
}

void SurfaceMarks::add(const SurfaceMark& mark) {
    marks_.push_back(mark);
    marks_.back().needed = static_cast<float>(double(marks_.size()) / area());
    before_.push_back(0);
    enter(static_cast<std::uint32_t>(marks_.size()));
    misses_ = 0;
    bestDistance_ = -1.0;
}

/// Enters mark number `number`, counted from 1, into its cell.
void SurfaceMarks::enter(std::uint32_t number) {
    std::uint32_t& last = cells_[cellOf(marks_[number - 1].at.position)];
    before_[number - 1] = last;
    last = number;
}

void SurfaceMarks::refineCells() {
    cells_.clear();
    for (std::uint32_t number = 1; number <= marks_.size(); ++number) {
        enter(number);
    }
}

} // namespace patina
