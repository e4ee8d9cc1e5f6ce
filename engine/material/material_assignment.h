// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "material/block_assignment.h"

namespace patina {

/// Chooses another block of a kind beside the model, or none by the kind's word for that; values
/// that both blocks have carry over. Always true, or an error where the block is not known or the
/// model has no place for it.
Result<bool> choosePart(Material& material, const std::string& kind, const std::string& id,
                        const Catalog& catalog);

/// Makes the assignment "id=value" to a parameter of the model, to a setting of every material, to
/// an accuracy choice, or to a part, whose kind and a dot may precede the id. The first of these
/// that has the id takes it.
Result<void> assignInMaterial(Material& material, const std::string& assignment,
                              const Catalog& catalog);

/// Returns the parameter that such an id names; null where it names nothing, an accuracy choice or
/// a part as a whole.
const Parameter* parameterIn(const Material& material, std::string_view id, const Catalog& catalog);

} // namespace patina
