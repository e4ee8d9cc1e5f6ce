// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "document/document.h"

namespace patina {

/// Gives the values of the active material's model and of its parts random values within their
/// sliders (see randomValue()), as one undo step. Locked values stay. `next` returns random
/// numbers, 0 .. 1.
void randomiseMaterial(Document& document, const std::function<double()>& next);

} // namespace patina
