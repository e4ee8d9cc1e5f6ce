// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "material/block_assignment.h"

namespace patina {

/// Chooses another block of a kind beside the model, or none; values that both have carry over.
Result<bool> choosePart(Material& material, const std::string& kind, const std::string& id,
                        const Catalog& catalog);

/// Makes the assignment "id=value": of a parameter of the model, of what every material has, of an
/// accuracy choice, or of a part, whose kind and a dot may stand before the id.
Result<void> assignInMaterial(Material& material, const std::string& assignment,
                              const Catalog& catalog);

/// Returns the parameter that such an id names; null where it names none, or no parameter.
const Parameter* parameterIn(const Material& material, std::string_view id, const Catalog& catalog);

} // namespace patina
