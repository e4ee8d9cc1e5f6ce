// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

namespace patina {

/// The linear floats that encode to exactly the 8-bit values of a picture as it is shown, which
/// came divided by 255. Alpha stays.
Image linearFromDisplay(Image display);

} // namespace patina
