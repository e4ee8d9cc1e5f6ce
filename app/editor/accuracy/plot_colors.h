// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>

class QCustomPlot;

namespace patina {

/// The colour at `share` of the way from `a` to `b`.
QColor mixed(const QColor& a, const QColor& b, double share);

/// Ground, axes and grid of a plot in the palette's colours; fainter where it is stale.
void colourPlot(QCustomPlot& plot, const QPalette& palette, bool stale);

} // namespace patina
