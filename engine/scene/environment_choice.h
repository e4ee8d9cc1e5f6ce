// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/catalog.h"
#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Puts an environment into the scene by a block's id, by a file for the block that shows one, or
/// by "none". It is an error where there is no such block and no such file.
Result<void> chooseEnvironment(Scene& scene, const std::string& choice, const Catalog& catalog);

} // namespace patina
