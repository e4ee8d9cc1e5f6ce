// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/material.h"

namespace patina {

/// Tells whether a part of this kind does anything with the model: it fills one of its slots, or
/// its kind works without a slot, as Fresnel blocks do by blending the sum of the lights.
bool hasPlaceFor(const Block& model, std::string_view kind);

/// Returns the material with another model of the catalogue. withModel() carries its values over.
/// A part that filled a slot rests while the model has no such slot, where it would work on the
/// whole surface, and comes back with the slot; a part that was turned on for models without the
/// slot rests while there is one. What rests is kept in `parked`, and so in files.
/// Where only black would carry over (a metal has no diffuse colour) and nothing could be seen, the
/// new model's own colours are used until the next swap.
Material swappedModel(const Material& material, const Block& newModel, const Catalog& catalog);

} // namespace patina
