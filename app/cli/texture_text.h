// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Returns the absolute paths of the images that such assignments name.
std::vector<std::string> filesIn(const std::vector<std::string>& assignments);

} // namespace patina
