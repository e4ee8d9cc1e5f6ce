// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>

class QCustomPlot;

namespace patina {

/// Returns a colour between `a` (`share` 0) and `b` (1).
QColor mixed(const QColor& a, const QColor& b, double share);

/// Gives background, axes and grid of a plot the palette's colours, fainter if it is stale.
void colourPlot(QCustomPlot& plot, const QPalette& palette, bool stale);

} // namespace patina
