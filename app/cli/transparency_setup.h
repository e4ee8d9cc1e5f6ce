// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "cli/picture_options.h"
#include "scene/scene.h"

namespace patina {

/// Puts the choice of the options into the scene: `--transparency`, which is a block's id or
/// "sorted", and `--set transparency.<id>=value`.
Result<void> chooseTransparency(Scene& scene, const PictureOptions& options,
                                const Catalog& catalog);

} // namespace patina
