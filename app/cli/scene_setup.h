// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assets/file_rights.h"
#include "catalog/catalog.h"
#include "cli/picture_options.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Holds the scene to draw, the warnings from reading it, and what may be read for it.
struct SceneSetup {
    Scene scene;
    Errors notes;
    FileRights rights; ///< covers the meshes, pictures and links that the scene names
};

/// Returns the scene of the options (or the shipped default scene), with `preset` on its first
/// object unless that is empty, and all other options applied.
Checked<SceneSetup> sceneFor(const std::string& preset, const PictureOptions& options,
                             const Catalog& catalog);

} // namespace patina
