// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QImage>

namespace patina {

/// A picture with soft corners at its own resolution, which is not tinted when it is chosen.
QIcon rounded(const QImage& picture);

} // namespace patina
