// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "material/material.h"

namespace patina {

/// Applies an assignment: "diffuse.color=wood.png" lays an image on a value, "normal=bumps.png" on
/// the whole material, and "diffuse.color:wrap=mirror" changes a setting of an image that is there.
Result<void> applyTexture(Material& material, const std::string& assignment,
                          const Catalog& catalog);

/// Returns as such an assignment what --set says of an image, in the words of preset files:
/// "textures.diffuse.color=wood.png" or "textures.diffuse.color.file=wood.png", then
/// "textures.diffuse.color.wrap=mirror"; without the first word a file on a value that takes one.
/// Nothing where it sets something else.
std::optional<std::string> textureAssignment(const Material& material, const std::string& set,
                                             const Catalog& catalog);

/// Returns the absolute paths of the images that `textures`, such assignments, and `sets` in the
/// words of preset files name.
std::vector<std::string> filesIn(const std::vector<std::string>& textures,
                                 const std::vector<std::string>& sets);

} // namespace patina
