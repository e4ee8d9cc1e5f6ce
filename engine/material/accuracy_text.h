// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/error.h"
#include "material/material.h"

namespace patina {

/// Tells whether levels of accuracy choices are chosen of blocks of a kind: those of materials, by
/// their presets. Blocks of scenes and lights are drawn by their exact way.
bool hasChosenLevels(std::string_view kind);

/// Returns the accuracy choice of a block that the material uses, named by its id alone or with the
/// block's kind or the word "accuracy" and a dot before it. Null where none has this name.
const AccuracyChoice* accuracyChoiceIn(const Material& material, const std::string& name,
                                       const Catalog& catalog);

/// Sets the level of such a choice. Returns false where no choice has this name, and an error where
/// the choice has no such level.
Result<bool> setLevel(Material& material, const std::string& name, const std::string& level,
                      const Catalog& catalog);

} // namespace patina
