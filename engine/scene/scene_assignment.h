// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/catalog.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Tells whether an assignment of `--set` is about a scene and not about a material:
/// "fog.density=0.1", "light.key.intensity=2", "shadow.angle=3" (of all lights that have a shadow),
/// "light.key.enabled=false", "scene.exposure=1", "camera.yaw=0", "object.visible=false" ... What a
/// word of the scene begins may be a value of materials alone ("tone.curve"): then it is about
/// those.
bool isForScene(const std::string& assignment, const Catalog& catalog);

/// Sets the value in the scene, or in one of its objects.
Result<void> assignInScene(Scene& scene, const std::string& assignment, const Catalog& catalog,
                           std::size_t object = 0);

/// Holds what an id such as "fog.density" names in a scene.
struct NamedParameter {
    const Parameter* parameter = nullptr; ///< null: none
    std::string owner{};                  ///< for people: "Fog", "Key"; empty: the scene itself
};
NamedParameter parameterIn(const Scene& scene, std::string_view id, const Catalog& catalog);

/// Returns the light of a name, in capitals or not; null where there is none.
Light* lightNamed(Scene& scene, std::string_view name);

/// Returns what an error expects in place of a name that no light has: those there are.
std::string expectedLights(const Scene& scene, std::string_view name);

} // namespace patina
