// SPDX-License-Identifier: GPL-3.0-or-later
// Writes charts to files, which have to be understood without the window.
#pragma once

#include <QByteArray>
#include <QStringList>
#include <QWidget>

#include "accuracy/plot_marks.h"
#include "core/error.h"

namespace patina {

/// Asks for a file with the given suffix ("csv") and returns its path; empty if cancelled.
QString askForChartFile(QWidget* parent, const QString& ending,
                        const QString& name = QStringLiteral("accuracy"));

/// Holds the lines above a chart: a title that names the subject, and below it how it was measured.
struct ChartHeading {
    QString title;
    QStringList lines;
};

/// Return the chart with its heading as a file of 960 x 600 pixels (PNG: twice that). Points on the
/// front and the current one are labelled.
QByteArray chartPng(const PlotMarks::Content& content, const ChartHeading& heading,
                    const QPalette& palette);
QByteArray chartSvg(const PlotMarks::Content& content, const ChartHeading& heading,
                    const QPalette& palette);

/// Returns the version and the driver of OpenGL as text for people; empty if no context can be
/// made. Call it in the window's thread.
QString driverLine();

} // namespace patina
