// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/fog_reach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/vectors.h"
#include "render/lights/shadow_view.h"

namespace patina {
namespace {

/// The box counts as larger by this share of the distance to what is drawn, because outlines extend
/// beyond a shape and shaders round.
constexpr double margin = 0.01;

constexpr std::array<glm::dvec3, 3> axes{glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0),
                                         glm::dvec3(0.0, 0.0, 1.0)};

/// Tells whether a box and the convex hull of the eye and eight corners are separate. Coordinates
/// are relative to the middle of the box.
class Apart {
  public:
    Apart(const glm::dvec3& half, const glm::dvec3& eye, const FogReach::Corners& corners)
        : half_(half), eye_(eye), corners_(corners) {}

    bool along(const glm::dvec3& direction) const {
        const double reach = glm::dot(half_, glm::abs(direction));
        double minPlace = glm::dot(eye_, direction);
        double maxPlace = minPlace;
        for (const glm::dvec3& corner : corners_) {
            const double place = glm::dot(corner, direction);
            minPlace = std::min(minPlace, place);
            maxPlace = std::max(maxPlace, place);
        }
        return minPlace > reach || maxPlace < -reach;
    }

    /// Returns true when some axis separates the two: a normal of a face, or the cross product of
    /// two edges (the separating axis theorem).
    bool anywhere() const {
        const std::array<glm::dvec3, 3> edges{corners_[1] - corners_[0], corners_[2] - corners_[0],
                                              corners_[4] - corners_[0]};
        return std::ranges::any_of(axes, [this](const glm::dvec3& axis) { return along(axis); }) ||
               acrossRays() || across(edges, axes) || across(edges, edges);
    }

  private:
    bool across(std::span<const glm::dvec3> some, std::span<const glm::dvec3> others) const {
        for (const glm::dvec3& one : some) {
            for (const glm::dvec3& other : others) {
                if (along(glm::cross(one, other))) {
                    return true;
                }
            }
        }
        return false;
    }

    bool acrossRays() const {
        FogReach::Corners rays = corners_;
        for (glm::dvec3& ray : rays) {
            ray -= eye_;
        }
        return across(rays, axes) || across(rays, rays);
    }

    glm::dvec3 half_;
    glm::dvec3 eye_;
    const FogReach::Corners& corners_;
};

} // namespace

FogReach::FogReach(const Scene& scene, const Catalog& catalog, const glm::dvec3& eye) : eye_(eye) {
    const Block* block = blockOf(scene.parts, kinds::fog, catalog);
    if (block != nullptr && isFinite(eye)) {
        box_ = fogBox(*block, scene.part(kinds::fog)->parameters);
        layer_ = fogLayer(*block, scene.part(kinds::fog)->parameters);
    }
}

void FogReach::add(const Corners& corners) {
    if (box_ && !isMet_) {
        isMet_ = ++count_ > maxCount || meets(corners);
    }
    if (layer_) {
        addHeights(corners);
    }
}

void FogReach::add(const Bounds& bounds, const glm::dmat4& world) {
    if (!asks() || bounds.empty()) {
        return;
    }
    Corners corners;
    for (int corner = 0; corner < 8; ++corner) {
        corners[static_cast<std::size_t>(corner)] = glm::dvec3(world * cornerOf(bounds, corner));
    }
    add(corners);
}

void FogReach::addHeights(const Corners& corners) {
    double lowest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;
    for (const glm::dvec3& corner : corners) {
        if (!isFinite(corner)) {
            lowest_ = -std::numeric_limits<double>::infinity();
            return;
        }
        lowest = std::min(lowest, corner.y);
        farthest = std::max(farthest, glm::distance(corner, eye_));
    }
    lowest_ = std::min(lowest_, lowest - margin * farthest);
}

/// The density never rises with height, so a path to the lowest point has the highest mean density.
double FogReach::thickness() const {
    if (!layer_ || !std::isfinite(lowest_)) {
        return 1.0;
    }
    const double rounding =
        1e-6 * std::max({std::abs(eye_.y), std::abs(lowest_), std::abs(layer_->base)});
    return layer_->between(eye_.y - rounding, lowest_ - rounding);
}

bool FogReach::meets(const Corners& corners) const {
    Corners seen = corners;
    double farthest = 0.0;
    for (glm::dvec3& corner : seen) {
        if (!isFinite(corner)) {
            return true;
        }
        farthest = std::max(farthest, glm::distance(corner, eye_));
        corner -= box_->center;
    }
    const glm::dvec3 half = 0.5 * box_->size + glm::dvec3(margin * farthest);
    return !Apart(half, eye_ - box_->center, seen).anywhere();
}

EffectView effectView(const DepthRange& depths, const FogReach& fog) {
    EffectView view;
    if (depths.farthest() > 0.0) {
        view.farthest = depths.farthest();
    }
    view.missesFog = fog.misses();
    view.fogThickness = fog.thickness();
    return view;
}

} // namespace patina
