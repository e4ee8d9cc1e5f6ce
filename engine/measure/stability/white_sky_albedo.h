// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/material.h"

namespace patina {

/// Returns the share of a uniform white sky's light that a model reflects with its default values,
/// as luminance: its directional albedo averaged over the directions of the light by their cosine,
/// in double precision. Above 1 it reflects more than arrives. Nothing is returned for a model
/// that cannot be evaluated so.
std::optional<double> whiteSkyAlbedo(const Catalog& catalog, const Block& model);

/// Returns this share for a material's model with the material's values and what fills its slot,
/// without images.
std::optional<double> whiteSkyAlbedo(const Catalog& catalog, const Material& material);

} // namespace patina
