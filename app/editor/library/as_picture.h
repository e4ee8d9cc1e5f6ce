// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "core/image.h"

namespace patina {

/// Converts a picture as it is shown, divided by 255.
QImage asPicture(const Image& image);

} // namespace patina
