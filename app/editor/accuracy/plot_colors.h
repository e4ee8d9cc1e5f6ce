// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>

class QCustomPlot;

namespace patina {

/// Gives background, axes and grid of a plot the palette's colours, fainter if it is stale.
void colourPlot(QCustomPlot& plot, const QPalette& palette, bool stale);

} // namespace patina
