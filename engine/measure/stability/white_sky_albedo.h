// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "catalog/catalog.h"

namespace patina {

/// The share of an even white sky's light that a white material of a model gives back: its
/// directional albedo, averaged over the directions of the light by their cosine, in double
/// precision. White: every colour of the model and of what fills its slot is as bright as it can
/// be, all else is at its default. 1: nothing is lost; more: it sends out more than arrives.
/// Nothing for a block without code in double precision.
std::optional<double> whiteAlbedo(const Catalog& catalog, const Block& model);

} // namespace patina
