// SPDX-License-Identifier: GPL-3.0-or-later
// Charts as files, which have to be understood without the window.
#pragma once

#include <QByteArray>
#include <QStringList>
#include <QWidget>

#include "accuracy/plot_marks.h"
#include "core/error.h"

namespace patina {

/// Asks for a file with the given ending ("csv") and returns it, or an empty text.
QString askForChartFile(QWidget* parent, const QString& ending);

/// Holds what stands above the chart: what it is of, and below that how it was measured.
struct ChartHeading {
    QString title;
    QStringList lines;
};

/// The chart with its heading; ways on the front and the one chosen now have their names beside
/// them.
QByteArray chartPng(const PlotMarks::Content& content, const ChartHeading& heading,
                    const QPalette& palette);
QByteArray chartSvg(const PlotMarks::Content& content, const ChartHeading& heading,
                    const QPalette& palette);

/// The driver of OpenGL, for people; empty where there is none.
QString driverLine();

} // namespace patina
