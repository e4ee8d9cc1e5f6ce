// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns every mistake in what the choices of a descriptor set (see fills.h), each at its place.
Errors fillMistakes(const Descriptor& descriptor);

} // namespace patina
