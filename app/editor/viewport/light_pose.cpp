// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/light_pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "viewport/spaces.h"

namespace patina {
namespace {

/// A light without a position is drawn so far from the pivot, as a share of half the height that
/// the view shows there.
constexpr double shownShare = 0.75;

/// A caster is at most so far from its shadow, as a share of the distance from the shadow to the
/// light.
constexpr double casterShare = 0.5;

/// Degrees between the axis and the side of a cone that a light's distance goes by; `usualCone` is
/// that of a light that shines everywhere.
constexpr double narrowestCone = 5.0;
constexpr double usualCone = 30.0;
constexpr double widestCone = 60.0;

/// Is the cosine of ten degrees, within which two directions are the same to the eye.
constexpr double sameWay = 0.985;

const Parameter* firstWith(const Block& light, bool wantsPoint) {
    const auto found = std::ranges::find_if(light.parameters, [wantsPoint](const Parameter& each) {
        return each.space != Space::None && isPoint(each.space) == wantsPoint;
    });
    return found == light.parameters.end() ? nullptr : &*found;
}

glm::dvec3 vectorOf(const Values& values, const Parameter& parameter) {
    const auto found = values.find(parameter.id);
    const Value& value = found == values.end() ? parameter.defaultValue : found->second;
    const auto* vector = std::get_if<glm::dvec3>(&value);
    return vector ? *vector : glm::dvec3(0.0);
}

double degreesOf(const Values& values, const Parameter& parameter) {
    const auto found = values.find(parameter.id);
    const Value& value = found == values.end() ? parameter.defaultValue : found->second;
    const auto* number = std::get_if<double>(&value);
    return number ? *number : 0.0;
}

glm::dvec3 toWorld(const glm::dvec3& vector, Space space, const Camera& camera) {
    if (!isOfCamera(space)) {
        return vector;
    }
    const glm::dmat4 world = glm::inverse(viewMatrix(camera));
    return glm::dvec3(world * glm::dvec4(vector, isPoint(space) ? 1.0 : 0.0));
}

glm::dvec3 fromWorld(const glm::dvec3& vector, Space space, const Camera& camera) {
    if (!isOfCamera(space)) {
        return vector;
    }
    return glm::dvec3(viewMatrix(camera) * glm::dvec4(vector, isPoint(space) ? 1.0 : 0.0));
}

std::optional<glm::dvec3> asUnit(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return std::isfinite(length) && length > 0.0 ? std::optional(vector / length) : std::nullopt;
}

} // namespace

std::optional<LightPose> lightPose(const Values& values, const Block& light, const Camera& camera) {
    LightPose place;
    place.pointOf = firstWith(light, true);
    place.directionOf = firstWith(light, false);
    if (place.directionOf) {
        place.direction =
            asUnit(toWorld(vectorOf(values, *place.directionOf), place.directionOf->space, camera));
    }
    if (light.reach && !light.reach->angle.empty() && place.direction) {
        place.angleOf = light.parameter(light.reach->angle);
        place.angle = place.angleOf ? degreesOf(values, *place.angleOf) : 0.0;
    }
    if (place.pointOf) {
        place.point = toWorld(vectorOf(values, *place.pointOf), place.pointOf->space, camera);
        return place;
    }
    if (!place.direction) {
        return std::nullopt;
    }
    const double shown = camera.distance * std::tan(0.5 * glm::radians(camera.fieldOfView));
    place.point = camera.pivot - *place.direction * (shownShare * shown);
    return place;
}

Values valuesAt(const LightPose& place, const Camera& camera) {
    Values values;
    if (place.pointOf) {
        values.emplace(place.pointOf->id, fromWorld(place.point, place.pointOf->space, camera));
    }
    if (place.directionOf && place.direction) {
        values.emplace(place.directionOf->id,
                       fromWorld(*place.direction, place.directionOf->space, camera));
    }
    return values;
}

LightPose aimedAt(const LightPose& before, const LightPose& after, const Ball& ball) {
    const bool isNewPlace = after.hasPoint() && !before.hasPoint() && before.direction;
    const bool isNewDirection = after.directionOf != nullptr && !before.direction;
    LightPose aimed = after;
    if (isNewPlace) {
        const auto way = asUnit(ball.center - after.point);
        const bool isThere = way && glm::dot(*way, *before.direction) > sameWay;
        const double angle =
            after.angleOf != nullptr ? std::min(after.angle, widestCone) : usualCone;
        const double away = ball.radius / std::sin(glm::radians(std::max(angle, narrowestCone)));
        aimed.point = isThere ? after.point : ball.center - *before.direction * away;
    }
    if (isNewPlace || isNewDirection) {
        const auto way = asUnit(ball.center - aimed.point);
        aimed.direction = way && after.directionOf != nullptr ? way : after.direction;
    }
    return aimed;
}

LightPose withHighlightAt(const LightPose& place, const glm::dvec3& point, const glm::dvec3& normal,
                          const Camera& camera) {
    const auto toEye = asUnit(eye(camera) - point);
    if (!toEye) {
        return place;
    }
    const glm::dvec3 toLight = 2.0 * glm::dot(normal, *toEye) * normal - *toEye;
    LightPose moved = place;
    moved.point = point + toLight * glm::distance(place.point, point);
    moved.direction = place.directionOf ? std::optional(-toLight) : std::nullopt;
    return moved;
}

LightPose withShadowAt(const LightPose& place, const glm::dvec3& point, const glm::dvec3& caster) {
    const auto toLight = asUnit(caster - point);
    if (!toLight) {
        return place;
    }
    const double away =
        std::max(glm::distance(place.point, point), glm::distance(caster, point) / casterShare);
    LightPose moved = place;
    moved.point = point + *toLight * away;
    moved.direction = place.directionOf ? std::optional(-*toLight) : std::nullopt;
    return moved;
}

} // namespace patina
