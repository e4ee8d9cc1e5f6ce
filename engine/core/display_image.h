// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

namespace patina {

/// Returns the linear floats that encode to exactly the 8-bit values of a picture as it is shown,
/// whose channels are given divided by 255. Alpha stays as it is.
Image linearFromDisplay(Image display);

} // namespace patina
