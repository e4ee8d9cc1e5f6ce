// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/catalog.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Puts an environment into the scene: a block's id, a file for the block that shows one, or
/// "none".
Result<void> chooseEnvironment(Scene& scene, const std::string& choice, const Catalog& catalog);

} // namespace patina
