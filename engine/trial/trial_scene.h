// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// A small scene that shows the block with its defaults, beside blocks that ship.
Scene trialScene(const Block& block, const Catalog& catalog);

} // namespace patina
