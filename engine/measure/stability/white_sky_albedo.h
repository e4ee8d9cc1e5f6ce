// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/material.h"

namespace patina {

/// Returns the share of an even white sky's light that a model gives back with its own values, as
/// luminance: its directional albedo, averaged over the directions of the light by their cosine, in
/// double precision. Above 1: it sends out more than arrives. Nothing for a block without code in
/// double precision.
std::optional<double> whiteSkyAlbedo(const Catalog& catalog, const Block& model);

/// Returns the same of a material's model with the material's values and what fills its slot.
/// Images are left out.
std::optional<double> whiteSkyAlbedo(const Catalog& catalog, const Material& material);

} // namespace patina
