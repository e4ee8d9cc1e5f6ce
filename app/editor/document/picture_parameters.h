// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "catalog/parameter.h"
#include "scene/scene.h"

namespace patina {

/// Returns the choices of the picture's accuracy as parameters of a form: "picture.<choice>".
std::vector<Parameter> pictureAccuracyParameters();

/// Returns the id of the level that the scene has of a choice; nothing where the id names no such
/// choice.
std::optional<Value> pictureLevel(const Scene& scene, std::string_view parameterId);

/// Sets the level of a choice; does nothing where the id or the level is not known.
void storePictureLevel(Scene& scene, std::string_view parameterId, const Value& value);

} // namespace patina
