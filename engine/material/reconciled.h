// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/material.h"

namespace patina {

/// Returns the values of a block after its descriptor may have changed: values are kept by id, what
/// no longer fits is parked and comes back when it fits again. A block that the new catalogue does
/// not know stays as it is.
BlockValues reconciled(const BlockValues& values, std::string_view kind, const Catalog& before,
                       const Catalog& after);

/// Returns the same for all blocks of a material.
Material reconciled(const Material& material, const Catalog& before, const Catalog& after);

} // namespace patina
