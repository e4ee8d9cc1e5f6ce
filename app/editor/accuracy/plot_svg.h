// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>

class QCustomPlot;

namespace patina {

/// Returns a plot as an SVG file of that size in pixels, with a title and a description for those
/// who cannot see it.
QByteArray plotSvg(QCustomPlot& plot, QSize size, const QString& title = {},
                   const QString& description = {});

} // namespace patina
