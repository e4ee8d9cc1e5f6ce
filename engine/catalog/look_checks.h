// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns the mistakes in `looks`: of what is no model, stated twice, or with values of parameters
/// that neither the model nor what fills its slots has.
Errors lookMistakes(const Descriptor& descriptor);

} // namespace patina
