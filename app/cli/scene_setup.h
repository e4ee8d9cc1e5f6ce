// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assets/file_rights.h"
#include "catalog/catalog.h"
#include "cli/picture_options.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// The scene to draw, and what its reader had to say.
struct SceneSetup {
    Scene scene;
    Errors notes;
    FileRights rights; ///< to the meshes, pictures and links that it names
};

/// The scene of the options (or the shipped default scene) with a preset, when `preset` is not
/// empty, and everything else that was asked for on its first object.
Checked<SceneSetup> sceneFor(const std::string& preset, const PictureOptions& options,
                             const Catalog& catalog);

} // namespace patina
