// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns every mistake in the tables of a descriptor and in the levels that read them, each at
/// its place.
Errors tableMistakes(const Descriptor& descriptor);

} // namespace patina
