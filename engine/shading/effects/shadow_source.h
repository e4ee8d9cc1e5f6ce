// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/material.h"
#include "shading/effects/opacity_part.h"
#include "shading/program/program_source.h"

namespace patina {

/// Returns the program that draws depths into the map of a light, with the uniform `worldToMap`.
Checked<ProgramSource> shadowMapProgram(const Catalog& catalog);

/// Tells whether an image of the material decides where it casts shadows.
bool isAlphaTested(const Material& material);

/// Returns what such a material's shadows depend on, with data of its own; nothing where no image
/// decides.
std::optional<OpacityPart> alphaTestOf(const Material& material, const Catalog& catalog);

/// Returns the program for an alpha-tested surface: also with the block of the object's data, and
/// `samplerName(0)`. An image that cuts out lets light pass where it does, another one where less
/// than half of the surface is there.
Checked<ProgramSource> shadowMapProgram(const OpacityPart& tested, const Catalog& catalog);

} // namespace patina
