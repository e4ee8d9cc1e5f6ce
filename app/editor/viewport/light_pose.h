// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "catalog/block.h"
#include "scene/scene.h"

namespace patina {

/// Says where a light is and where it shines, in world space, whatever its kind: the kind's
/// descriptor says which of its values are a point, a direction, a cone.
struct LightPose {
    glm::dvec3 point{0.0};               ///< of a light without a place, one it shines from
    std::optional<glm::dvec3> direction; ///< a unit vector along which it shines; none: everywhere
    double angle = 0.0;                  ///< degrees between the axis and the side of its cone
    const Parameter* pointOf = nullptr;  ///< the value that says so; null: there is none
    const Parameter* directionOf = nullptr;
    const Parameter* angleOf = nullptr;

    bool hasPoint() const { return pointOf != nullptr; }
};

/// The place of a light. Nothing where its kind has neither a point nor a direction.
std::optional<LightPose> lightPose(const Values& values, const Block& light, const Camera& camera);

/// The values that put a light there: those of its place and its direction alone.
Values valuesAt(const LightPose& place, const Camera& camera);

/// The light moved and turned so that a mirror at `point` with the unit normal `normal` shows it to
/// the eye; it stays as far away as it is.
LightPose withHighlightAt(const LightPose& place, const glm::dvec3& point, const glm::dvec3& normal,
                          const Camera& camera);

/// The light moved and turned so that what is at `caster` throws its shadow on `point`.
LightPose withShadowAt(const LightPose& place, const glm::dvec3& point, const glm::dvec3& caster);

} // namespace patina
