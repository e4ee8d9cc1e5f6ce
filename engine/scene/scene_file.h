// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "material/preset_file.h"
#include "scene/scene.h"

namespace patina {

struct SceneReading {
    Scene scene;
    Errors notes;
    bool readOnly = false;
};

/// Reads a scene. Mesh paths are kept relative to the file's folder in the file and made absolute
/// in the value; presets may be inline objects or relative paths of preset files.
Checked<SceneReading> readScene(const std::filesystem::path& path, const Catalog& catalog);

/// Whether a JSON file says by its "format" that it is a scene, whatever it is called.
bool saysItIsAScene(const std::filesystem::path& path);

/// The scene's JSON; mesh paths relative to `folder`.
nlohmann::json toJson(const Scene& scene, const std::filesystem::path& folder);

Result<void> writeScene(const std::filesystem::path& path, const Scene& scene);

} // namespace patina
