// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>

#include "viewport/comparison_meter.h"

namespace patina {

/// "B takes 31 % less time and is FLIP 0.012 away", of the other side; empty while nothing is
/// known.
QString comparisonText(const ComparisonNumbers& numbers);

/// All numbers, line by line.
QString comparisonDetails(const ComparisonNumbers& numbers);

/// What A and the other side have at a place, 0 .. 1 of their width and height.
QString pixelText(const ComparedFrames& frames, Side other, const QPointF& place);

} // namespace patina
