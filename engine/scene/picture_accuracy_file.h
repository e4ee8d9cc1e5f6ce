// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_reader.h"
#include "scene/scene.h"

namespace patina {

/// Reads a scene's `accuracy` from its file, with a note for each level and each key that is not
/// known; such keys are kept in Scene::unknown.
void readPictureAccuracy(JsonReader& file, Scene& scene, Errors& notes);

/// Adds `accuracy` to a scene's file, without choices that have their default level.
void writePictureAccuracy(nlohmann::json& file, const PictureAccuracy& accuracy);

} // namespace patina
