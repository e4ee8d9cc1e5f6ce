// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "material/material.h"

namespace patina {

/// "diffuse.color=wood.png" lays an image on a value, "normal=bumps.png" on the whole material, and
/// "diffuse.color:wrap=mirror" changes how one lies that is there.
Result<void> applyTexture(Material& material, const std::string& assignment,
                          const Catalog& catalog);

/// Returns the full paths of the images among such assignments.
std::vector<std::string> filesIn(const std::vector<std::string>& assignments);

} // namespace patina
