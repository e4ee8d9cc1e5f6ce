// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/catalog.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Tells whether an assignment of `--set` is about a scene and not about a material:
/// "fog.density=0.1", "light.key.intensity=2", "light.key.enabled=false", "scene.exposure=1",
/// "camera.yaw=0", "object.visible=false" ... An id that begins with a word of the scene may still
/// name a parameter that only blocks of materials have ("tone.curve"); it is then false.
bool isForScene(const std::string& assignment, const Catalog& catalog);

/// Sets the value in the scene, or in its object of this number; isForScene() must be true. It is
/// an error where the scene has nothing of this name or the value does not fit.
Result<void> assignInScene(Scene& scene, const std::string& assignment, const Catalog& catalog,
                           std::size_t object = 0);

/// Holds what an id such as "fog.density" names in a scene.
struct NamedParameter {
    const Parameter* parameter = nullptr; ///< is null where it names none
    std::string owner{};                  ///< is shown, as "Fog", "Key"; empty: the scene itself
};
NamedParameter parameterIn(const Scene& scene, std::string_view id, const Catalog& catalog);

/// Returns the first light of a name, in capitals or not; null where there is none.
Light* lightNamed(Scene& scene, std::string_view name);

/// Returns the lights' names, or a hint at the nearest of them, as what an error expects in place
/// of a name that no light has.
std::string expectedLights(const Scene& scene, std::string_view name);

} // namespace patina
