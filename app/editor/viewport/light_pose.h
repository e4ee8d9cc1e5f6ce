// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "catalog/block.h"
#include "render/lights/light_lists.h"
#include "scene/scene.h"

namespace patina {

/// Says where a light is and where it shines, in world space. It fits every kind: the kind's
/// descriptor says which of its values are a point, a direction, a cone.
struct LightPose {
    glm::dvec3 point{0.0}; ///< metres; lies along the direction for a light without a position
    /// Is a unit vector along which it shines; empty where it shines everywhere.
    std::optional<glm::dvec3> direction;
    double angle = 0.0; ///< degrees between the axis and the side of its cone
    /// Holds the point; null where the light has none.
    const Parameter* pointOf = nullptr;
    const Parameter* directionOf = nullptr;
    const Parameter* angleOf = nullptr;

    bool hasPoint() const { return pointOf != nullptr; }
};

/// Returns the pose of a light; nothing where its kind has neither a point nor a direction.
std::optional<LightPose> lightPose(const Values& values, const Block& light, const Camera& camera);

/// Returns the values that put a light there; only those of its position and its direction.
Values valuesAt(const LightPose& place, const Camera& camera);

/// Returns the pose `after`, of a light that had the pose `before` until it got another kind, so
/// that it lights the ball. Where its place is new it stands where it shone from, as far away as
/// its cone needs to hold the ball; where its direction is new it is aimed at the middle. A place
/// that it has had before stays where that is where it shone from.
LightPose aimedAt(const LightPose& before, const LightPose& after, const Ball& ball);

/// Returns the light moved and turned so that a mirror at `point` with the unit normal `normal`
/// shows it to the eye; its distance stays as it is. Nothing changes where the eye is at `point`.
LightPose withHighlightAt(const LightPose& place, const glm::dvec3& point, const glm::dvec3& normal,
                          const Camera& camera);

/// Returns the light moved and turned so that what is at `caster` throws its shadow on `point`. It
/// moves away where the caster would otherwise be nearer to the light than to the point.
LightPose withShadowAt(const LightPose& place, const glm::dvec3& point, const glm::dvec3& caster);

} // namespace patina
