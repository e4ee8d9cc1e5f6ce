// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "cli/picture_options.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Puts the blocks that the options name into the scene: `--fog` and its like, `--light` and
/// `--shadow`.
Result<void> chooseSceneBlocks(Scene& scene, const PictureOptions& options, const Catalog& catalog);

} // namespace patina
