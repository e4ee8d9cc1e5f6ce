// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/error.h"
#include "material/material.h"

namespace patina {

/// Says why the material has nothing that an image under this key could drive. Nothing is returned
/// where it has, or where a block of the material is missing from the catalogue.
std::optional<Error> whyNoImage(std::string_view key, const Material& material,
                                const Catalog& catalog);

} // namespace patina
