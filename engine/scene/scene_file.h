// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "material/preset_file.h"
#include "scene/scene.h"

namespace patina {

/// Holds what reading a scene gave; its notes are about things that lost nothing.
struct SceneReading {
    Scene scene;
    Errors notes;
    OutsideFiles outside;  ///< holds what it, or a preset of it, names and is not read
    bool readOnly = false; ///< says that a newer version wrote it
};

/// Reads a scene. Paths of meshes and pictures start at the file's folder and are absolute in the
/// value; presets may be inline objects or relative paths of preset files. Meshes and the
/// environment's picture are not read here: who reads them must leave out what is `outside`. A
/// preset that is outside is not read.
Checked<SceneReading> readScene(const std::filesystem::path& path, const Catalog& catalog,
                                const ReadingRights& rights = {});

/// Reads a scene from a document that is in no file, as one from the clipboard. Its paths start at
/// the folder of LocatedJson::file; where that is empty they are unchanged.
Checked<SceneReading> sceneFromJson(const LocatedJson& document, const Catalog& catalog,
                                    const ReadingRights& rights = {});

/// Tells whether a JSON file says by its "format" that it is a scene, whatever its name.
bool saysItIsAScene(const std::filesystem::path& path);

/// Returns the scene's JSON, whose paths are relative to `folder`.
nlohmann::json toJson(const Scene& scene, const std::filesystem::path& folder);

/// Returns the JSON of a scene that has nothing but these objects or lights; paths are unchanged.
nlohmann::json sceneJsonOf(std::span<const Object> objects);
nlohmann::json sceneJsonOf(std::span<const Light> lights);

Result<void> writeScene(const std::filesystem::path& path, const Scene& scene);

} // namespace patina
