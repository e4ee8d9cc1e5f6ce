// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/catalog.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Tells whether an assignment of `--set` is about a scene and not about a material:
/// "fog.density=0.1", "light.key.intensity=2", "light.key.enabled=false", "scene.exposure=1",
/// "camera.yaw=0", "object.visible=false" ... What a word of the scene begins may be a value of
/// materials alone ("tone.curve"): then it is about those.
bool isForScene(const std::string& assignment, const Catalog& catalog);

/// Sets the value in the scene, or in its first object.
Result<void> assignInScene(Scene& scene, const std::string& assignment, const Catalog& catalog);

/// The kind that files call so; null where there is none.
const BlockKind* kindCalled(std::string_view singular);

/// The light of a name, in capitals or not; null where there is none.
Light* lightNamed(Scene& scene, std::string_view name);

/// Returns what an error expects in place of a name that no light has: those there are.
std::string expectedLights(const Scene& scene, std::string_view name);

} // namespace patina
