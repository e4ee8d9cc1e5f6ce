// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// The mistakes in a descriptor that a schema cannot see: ranges, defaults, names used twice,
/// conditions over parameters that are not there, a missing shader. A part that the schema already
/// rejects is passed over.
Errors descriptorMistakes(const Descriptor& descriptor);

} // namespace patina
