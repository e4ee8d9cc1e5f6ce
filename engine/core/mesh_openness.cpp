// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh_openness.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <thread>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/triangle_tree.h"
#include "core/vectors.h"

namespace patina {
namespace {

constexpr std::size_t rayBudget = std::size_t(12) << 20; ///< rays, for each side of the surface
constexpr std::size_t minRays = 16;
constexpr std::size_t maxRays = 128;

/// Says how far above the surface rays begin, as a part of the mesh's radius.
constexpr float lift = 2e-5f;

/// Says how far from the vertex rays begin within the triangles around it, as a part of the
/// distance to their centroids: where a floor meets a wall, the vertex itself lies in the plane of
/// both.
constexpr float inset = 0.01f;

/// Is the unoccluded share at or below which a side counts as closed.
constexpr float minBack = 0.01f;

constexpr std::size_t verticesPerPart = 256;

/// Returns directions about +z, distributed by the cosine: a spiral on the disk below (Vogel 1979),
/// lifted to the sphere.
std::vector<glm::vec3> cosineDirections(std::size_t count) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<glm::vec3> directions(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double area = (double(i) + 0.5) / double(count);
        const double turn = golden * double(i);
        directions[i] = glm::vec3(std::sqrt(area) * std::cos(turn),
                                  std::sqrt(area) * std::sin(turn), std::sqrt(1.0 - area));
    }
    return directions;
}

/// Counts the unoccluded directions of one side of a vertex, and sums them.
struct Seen {
    std::size_t free = 0;
    glm::vec3 sum{0.0f};
};

/// Traces rays from vertices of a mesh scaled into the unit ball, so that floats are precise enough
/// wherever it lies.
class OpennessFinder {
  public:
    explicit OpennessFinder(const MeshView& mesh)
        : mesh_(mesh), middle_(middleOf(mesh.vertices)), scale_(scaleOf(mesh.vertices, middle_)),
          within_(waysWithin(mesh)),
          tree_(scale_ > 0.0 ? cornersOf(mesh) : std::vector<glm::vec3>()),
          directions_(cosineDirections(std::clamp(
              rayBudget / std::max<std::size_t>(mesh.vertices.size(), 1), minRays, maxRays))) {}

    VertexOpenness of(std::size_t index) const {
        const Vertex& vertex = mesh_.vertices[index];
        const double length = glm::length(glm::dvec3(vertex.normal));
        const glm::vec3 place = placed(vertex.position);
        const bool isUsable = scale_ > 0.0 && length > 1e-3 && length < 1e3 && isFinite(place) &&
                              isFinite(within_[index]);
        if (!isUsable) {
            return {};
        }
        const glm::vec3 n(glm::dvec3(vertex.normal) / length);
        return packed(n, seen(originAt(index, place, n), n), seen(originAt(index, place, -n), -n));
    }

  private:
    static glm::dvec3 middleOf(std::span<const Vertex> vertices) {
        glm::dvec3 lower(INFINITY);
        glm::dvec3 upper(-INFINITY);
        for (const Vertex& vertex : vertices) {
            if (isFinite(vertex.position)) {
                lower = glm::min(lower, glm::dvec3(vertex.position));
                upper = glm::max(upper, glm::dvec3(vertex.position));
            }
        }
        return 0.5 * (lower + upper);
    }

    /// Returns one over the farthest distance from the middle; 0 for a mesh without an extent.
    static double scaleOf(std::span<const Vertex> vertices, const glm::dvec3& middle) {
        double farthest = 0.0;
        for (const Vertex& vertex : vertices) {
            const double distance = glm::distance(glm::dvec3(vertex.position), middle);
            farthest = std::isfinite(distance) ? std::max(farthest, distance) : farthest;
        }
        return farthest > 1e-30 ? 1.0 / farthest : 0.0;
    }

    glm::vec3 placed(const glm::vec3& point) const {
        return glm::vec3((glm::dvec3(point) - middle_) * scale_);
    }

    std::vector<glm::vec3> cornersOf(const MeshView& mesh) const {
        std::vector<glm::vec3> corners;
        corners.reserve(mesh.indices.size());
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            for (std::size_t j = i; j < i + 3; ++j) {
                const std::uint32_t index = mesh.indices[j];
                corners.push_back(index < mesh.vertices.size()
                                      ? placed(mesh.vertices[index].position)
                                      : glm::vec3(NAN));
            }
        }
        return corners;
    }

    /// Returns for each vertex the mean of the vectors to the centroids of its triangles.
    std::vector<glm::vec3> waysWithin(const MeshView& mesh) const {
        std::vector<glm::vec3> ways(mesh.vertices.size(), glm::vec3(0.0f));
        std::vector<float> counts(mesh.vertices.size(), 0.0f);
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const auto corners = mesh.indices.subspan(i, 3);
            if (std::ranges::any_of(corners, [&](auto each) { return each >= ways.size(); })) {
                continue;
            }
            glm::vec3 middle(0.0f);
            for (const std::uint32_t corner : corners) {
                middle += placed(mesh.vertices[corner].position) / 3.0f;
            }
            for (const std::uint32_t corner : corners) {
                const glm::vec3 way = middle - placed(mesh.vertices[corner].position);
                ways[corner] += isFinite(way) ? way : glm::vec3(0.0f);
                counts[corner] += 1.0f;
            }
        }
        for (std::size_t i = 0; i < ways.size(); ++i) {
            ways[i] /= std::max(counts[i], 1.0f);
        }
        return ways;
    }

    /// Returns where the rays of a vertex begin. It is never below the plane of the normal, so that
    /// the corners of a convex shape stay outside.
    glm::vec3 originAt(std::size_t index, const glm::vec3& place, const glm::vec3& n) const {
        const glm::vec3 way = within_[index];
        const float below = std::min(glm::dot(way, n), 0.0f);
        return place + inset * (way - below * n) + lift * n;
    }

    Seen seen(const glm::vec3& origin, const glm::vec3& n) const {
        const glm::vec3 beside = std::abs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        const glm::vec3 t = glm::normalize(glm::cross(beside, n));
        const glm::vec3 b = glm::cross(n, t);
        Seen seen;
        for (const glm::vec3& local : directions_) {
            const glm::vec3 direction = local.x * t + local.y * b + local.z * n;
            if (!tree_.isHit(origin, direction)) {
                ++seen.free;
                seen.sum += direction;
            }
        }
        return seen;
    }

    /// Encodes both sides of a vertex. A side from which hardly anything is free is seen only by a
    /// pixel at an outline that takes the far side of a shape for the near one: it is taken for as
    /// open as the front.
    VertexOpenness packed(const glm::vec3& n, const Seen& front, const Seen& back) const {
        const auto share = [this](const Seen& seen) {
            return float(seen.free) / float(directions_.size());
        };
        VertexOpenness packed;
        if (front.free < directions_.size()) {
            const float length = glm::length(front.sum);
            const glm::vec3 direction = length > 1e-6f ? front.sum / length : n;
            const glm::vec3 apart = (share(front) * direction - n) / VertexOpenness::unit;
            packed.x = rounded(apart.x);
            packed.y = rounded(apart.y);
            packed.z = rounded(apart.z);
        }
        const float hidden = 1.0f - share(share(back) > minBack ? back : front);
        packed.back = rounded(1.0f + 32766.0f * hidden);
        return packed;
    }

    static std::int16_t rounded(float value) {
        return static_cast<std::int16_t>(std::lround(std::clamp(value, -32767.0f, 32767.0f)));
    }

    const MeshView& mesh_;
    glm::dvec3 middle_;
    double scale_;
    std::vector<glm::vec3> within_; ///< holds waysWithin(), one per vertex
    TriangleTree tree_;
    std::vector<glm::vec3> directions_;
};

} // namespace

Openness unpacked(const VertexOpenness& packed, const glm::vec3& normal) {
    const glm::vec3 apart(packed.x, packed.y, packed.z);
    const glm::vec3 seen = normal + apart * VertexOpenness::unit;
    const float length = glm::length(seen);
    return {std::min(length, 1.0f), length > 1e-3f ? seen / length : normal,
            1.0f - (float(packed.back) - 1.0f) / 32766.0f};
}

std::vector<VertexOpenness> opennessOf(const MeshView& mesh, Progress* progress) {
    const OpennessFinder finder(mesh);
    const std::size_t count = mesh.vertices.size();
    std::vector<VertexOpenness> openness(count);
    std::atomic<std::size_t> next{0};
    const auto isCancelled = [progress] { return progress != nullptr && progress->cancelled; };
    const auto work = [&] {
        while (!isCancelled()) {
            const std::size_t first = next.fetch_add(verticesPerPart);
            if (first >= count) {
                return;
            }
            for (std::size_t i = first; i < std::min(first + verticesPerPart, count); ++i) {
                openness[i] = finder.of(i);
            }
            if (progress != nullptr) {
                progress->done = float(first) / float(count);
            }
        }
    };
    const unsigned cores = std::thread::hardware_concurrency();
    {
        std::vector<std::jthread> helpers;
        for (unsigned i = 2; i < cores; ++i) {
            helpers.emplace_back(work);
        }
        work();
    }
    return isCancelled() ? std::vector<VertexOpenness>() : openness;
}

} // namespace patina
