// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace patina {

/// Returns a colour between `a` (`share` 0) and `b` (1).
QColor mixed(const QColor& a, const QColor& b, double share);

} // namespace patina
