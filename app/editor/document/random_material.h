// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "document/document.h"

namespace patina {

/// Gives the values of the active material's model, and of what works beside it, random ones that
/// sliders reach (see randomValue()), as one undo step. Locked ones stay.
void randomiseMaterial(Document& document, const std::function<double()>& next);

} // namespace patina
