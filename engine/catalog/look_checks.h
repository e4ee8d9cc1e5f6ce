// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns the mistakes in `looks`: of what no material is made of, stated twice, or with values of
/// parameters that neither the block nor what fills its slots has.
Errors lookMistakes(const Descriptor& descriptor);

} // namespace patina
