// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/error.h"
#include "material/material.h"

namespace patina {

/// Why the material has nothing that an image under this key could drive. Nothing when it has, or
/// when that cannot be told because the block in question is not in the catalogue.
std::optional<Error> whyNoImage(std::string_view key, const Material& material,
                                const Catalog& catalog);

} // namespace patina
