// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QImage>

namespace patina {

/// Returns an icon with rounded corners at the image's own resolution, which Qt does not tint when
/// its item is selected.
QIcon rounded(const QImage& picture);

} // namespace patina
