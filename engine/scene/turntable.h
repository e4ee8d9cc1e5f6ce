// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "catalog/catalog.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Tells what a turntable turns about the upright axis.
enum class TurntableOf { Object, Light, Environment };

inline constexpr std::array<std::string_view, 3> turntableWords{"object", "light", "environment"};

/// Returns a vector turned about a unit vector by degrees, as a right-handed screw.
glm::dvec3 turnedAbout(const glm::dvec3& vector, const glm::dvec3& axis, double degrees);

/// Returns the angles of a rotation matrix Rz Ry Rx: degrees about x, then y, then z. Where y is 90
/// or -90, z is 0.
glm::dvec3 anglesOf(const glm::dmat3& rotation);

/// Returns an object's rotation (degrees about x, then y, then z) after it was turned about a unit
/// vector of the world.
glm::dvec3 rotationTurnedAbout(const glm::dvec3& rotation, const glm::dvec3& axis, double degrees);

/// Returns the scene with all objects turned by degrees about the mean of their places, all lights
/// in world space turned about the camera's pivot, or its environment turned. It is an error where
/// no light or no environment can be turned.
Result<Scene> onTurntable(const Scene& scene, const Catalog& catalog, TurntableOf what,
                          double degrees);

/// Returns the file of a picture in a turntable's series, of which the first is 1: "turn.0001.png"
/// of "turn.png".
std::filesystem::path seriesFile(const std::filesystem::path& file, int number);

} // namespace patina
