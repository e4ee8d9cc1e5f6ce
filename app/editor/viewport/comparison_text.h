// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>

#include "viewport/comparison_meter.h"

namespace patina {

/// Returns how the other side compares with A, as in "B takes 31 % less time and is FLIP 0.012
/// away"; empty while nothing is known.
QString comparisonText(const ComparisonNumbers& numbers);

/// Returns all numbers, one per line.
QString comparisonDetails(const ComparisonNumbers& numbers);

/// Returns the values of A and of the other side at a place, 0 .. 1 of the frames' width and
/// height.
QString pixelText(const ComparedFrames& frames, Side other, const QPointF& place);

} // namespace patina
