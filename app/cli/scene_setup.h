// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "catalog/catalog.h"
#include "cli/picture_options.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// The scene to draw, and what its reader had to say.
struct SceneSetup {
    Scene scene;
    Errors notes;
    std::set<std::string, std::less<>> withheld; ///< meshes and pictures that are not to be read
};

/// The scene of the options (or the shipped default scene) with a preset, when `preset` is not
/// empty, and everything else that was asked for on its first object.
Checked<SceneSetup> sceneFor(const std::string& preset, const PictureOptions& options,
                             const Catalog& catalog);

} // namespace patina
