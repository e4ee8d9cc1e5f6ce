// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "core/image.h"

namespace patina {

/// Converts display values, 0 .. 1 in at least three channels, to 8 bits.
QImage asPicture(const Image& image);

} // namespace patina
