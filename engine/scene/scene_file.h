// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "material/preset_file.h"
#include "scene/scene.h"

namespace patina {

struct SceneReading {
    Scene scene;
    Errors notes;
    OutsideFiles outside; ///< what it, or a preset of it, names and is not read
    bool readOnly = false;
};

/// Reads a scene. Mesh paths are kept relative to the file's folder in the file and made absolute
/// in the value; presets may be inline objects or relative paths of preset files. Meshes and the
/// environment's picture are read by others, who leave out what is `outside`; a preset that is
/// outside is not read here.
Checked<SceneReading> readScene(const std::filesystem::path& path, const Catalog& catalog,
                                const ReadingRights& rights = {});

/// Reads a scene from a document that is in no file, as one that was copied; its paths begin where
/// the document says that it stands, and where it does not they stay as they are.
Checked<SceneReading> sceneFromJson(const LocatedJson& document, const Catalog& catalog,
                                    const ReadingRights& rights = {});

/// Tells whether a JSON file says by its "format" that it is a scene, whatever it is called.
bool saysItIsAScene(const std::filesystem::path& path);

/// Returns the scene's JSON; mesh paths relative to `folder`.
nlohmann::json toJson(const Scene& scene, const std::filesystem::path& folder);

/// Returns the JSON of a scene that says nothing but which objects or lights it has; paths stay as
/// they are.
nlohmann::json sceneJsonOf(std::span<const Object> objects);
nlohmann::json sceneJsonOf(std::span<const Light> lights);

Result<void> writeScene(const std::filesystem::path& path, const Scene& scene);

} // namespace patina
