// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_reader.h"
#include "scene/scene.h"

namespace patina {

/// Takes a scene's `accuracy` from its file, with a note for each level that is not known; keys
/// that are not known stay in Scene::unknown.
void readPictureAccuracy(JsonReader& file, Scene& scene, Errors& notes);

/// Writes it beside what is there, without choices that are as always.
void writePictureAccuracy(nlohmann::json& file, const PictureAccuracy& accuracy);

} // namespace patina
