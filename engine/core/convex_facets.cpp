// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/convex_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace patina {
namespace {

// Both are measured in the mesh's radius.
constexpr double coplanar =
    1e-5;                       ///< metres between a plane and the corners of one of its triangles
constexpr double convex = 1e-4; ///< metres by which a corner may lie in front of a plane
constexpr double closed = 1e-3; ///< of the area, that opposite sides may differ

constexpr double parallel = 0.99; ///< is the least cosine between triangles of a plane

constexpr std::size_t minPlanes = 4;

struct Triangle {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 area{0.0}; ///< is its normal times its area
};

class FacetFinder {
  public:
    explicit FacetFinder(const MeshView& mesh) : mesh_(mesh) {}

    ConvexFacets find() {
        for (const auto step :
             {&FacetFinder::measure, &FacetFinder::merge, &FacetFinder::checkConvex}) {
            if (std::string whyNot = (this->*step)(); !whyNot.empty()) {
                return {{}, std::move(whyNot)};
            }
        }
        for (FacetPlane& plane : planes_) {
            plane.offset += glm::dot(plane.normal, middle_);
        }
        return {std::move(planes_), ""};
    }

  private:
    std::size_t triangles() const { return mesh_.indices.size() / 3; }

    glm::dvec3 corner(std::size_t index) const {
        return glm::dvec3(mesh_.vertices[mesh_.indices[index]].position) - middle_;
    }

    Triangle triangle(std::size_t index) const {
        const glm::dvec3 a = corner(3 * index);
        const glm::dvec3 b = corner(3 * index + 1);
        const glm::dvec3 c = corner(3 * index + 2);
        return {{a, b, c}, 0.5 * side_ * glm::cross(b - a, c - a)};
    }

    /// Finds the size of the mesh and the side to which its triangles face, and sees by Gauss'
    /// theorem whether they close: the integral of x n^T over a closed surface is its volume.
    std::string measure() {
        if (triangles() > ConvexFacets::maxTriangles) {
            return fmt::format("it has more than {} triangles", ConvexFacets::maxTriangles);
        }
        const Bounds& bounds = mesh_.bounds;
        middle_ = glm::dvec3(bounds.center());
        radius_ = 0.5 * glm::length(glm::dvec3(bounds.size()));
        if (bounds.empty() || !std::isfinite(radius_) || !(radius_ > 0.0)) {
            return "it has no extent";
        }
        glm::dvec3 sum(0.0);
        glm::dmat3 moment(0.0);
        double area = 0.0;
        for (std::size_t i = 0; i < triangles(); ++i) {
            const Triangle each = triangle(i);
            sum += each.area;
            area += glm::length(each.area);
            moment += glm::outerProduct((each.corners[0] + each.corners[1] + each.corners[2]) / 3.0,
                                        each.area);
        }
        const double volume = (moment[0][0] + moment[1][1] + moment[2][2]) / 3.0;
        moment -= glm::dmat3(volume);
        double open = glm::length(sum) * radius_;
        for (int i = 0; i < 3; ++i) {
            open = std::max(open, glm::length(moment[i]));
        }
        side_ = volume < 0.0 ? -1.0 : 1.0;
        const bool isClosed = open <= closed * area * radius_ && std::abs(volume) > 0.0;
        return isClosed ? "" : "it is not closed";
    }

    std::string merge() {
        std::size_t last = 0;
        for (std::size_t i = 0; i < triangles(); ++i) {
            const Triangle each = triangle(i);
            const double area = glm::length(each.area);
            if (!(area > 1e-14 * radius_ * radius_)) {
                continue;
            }
            const glm::dvec3 normal = each.area / area;
            if (last < planes_.size() && lies(each, normal, planes_[last])) {
                continue;
            }
            const auto found =
                std::ranges::find_if(planes_, [&each, &normal, this](const FacetPlane& plane) {
                    return lies(each, normal, plane);
                });
            last = static_cast<std::size_t>(found - planes_.begin());
            if (found != planes_.end()) {
                continue;
            }
            if (planes_.size() == ConvexFacets::maxPlanes) {
                return fmt::format("it has more than {} flat facets", ConvexFacets::maxPlanes);
            }
            planes_.push_back({normal, glm::dot(normal, each.corners[0])});
        }
        return planes_.size() < minPlanes ? "it is not closed" : "";
    }

    bool lies(const Triangle& triangle, const glm::dvec3& normal, const FacetPlane& plane) const {
        return glm::dot(normal, plane.normal) > parallel &&
               std::ranges::all_of(triangle.corners, [&plane, this](const glm::dvec3& corner) {
                   return std::abs(glm::dot(plane.normal, corner) - plane.offset) <=
                          coplanar * radius_;
               });
    }

    std::string checkConvex() {
        for (std::size_t i = 0; i < mesh_.indices.size(); ++i) {
            const glm::dvec3 x = corner(i);
            const bool isBehind = std::ranges::all_of(planes_, [&x, this](const FacetPlane& plane) {
                return glm::dot(plane.normal, x) - plane.offset <= convex * radius_;
            });
            if (!isBehind) {
                return "it is not convex";
            }
        }
        return "";
    }

    const MeshView& mesh_;
    glm::dvec3 middle_{0.0}; ///< is where the planes' offsets count from
    double radius_ = 0.0;
    double side_ = 1.0; ///< is -1 where the triangles face inwards
    std::vector<FacetPlane> planes_;
};

} // namespace

ConvexFacets convexFacetsOf(const MeshView& mesh) {
    return FacetFinder(mesh).find();
}

} // namespace patina
