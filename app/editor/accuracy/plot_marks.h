// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QPalette>
#include <QPointF>
#include <QSharedPointer>

#include "measure/cost/cost_chart.h"

class QCPErrorBars;
class QCPGraph;
class QCustomPlot;

namespace patina {

class AxisTicks;

/// Draws a chart of costs in a plot: points, their intervals, the front, rings and axes.
class PlotMarks {
  public:
    /// Adds its graphs to the plot, which owns them.
    explicit PlotMarks(QCustomPlot& plot);

    /// Holds what is to be drawn; points are given by index, -1 for none.
    struct Content {
        const CostChart& chart;
        int current = -1;  ///< gets a ring of the text's colour
        int selected = -1; ///< gets a ring of the highlight's colour
        bool stale = false;
    };
    void draw(const Content& content, const QPalette& palette);

    /// Holds the graphs of the points of one standing.
    struct Dots {
        QCPGraph* known;  ///< has discs
        QCPGraph* bounds; ///< has arrows, for times that are bounds

        void colour(const QColor& edge, const QColor& inside) const;
    };

    /// Returns where a point is drawn, in pixels of the plot.
    QPointF placeOf(const CostPoint& point, const CostChart& chart) const;

  private:
    void drawPoints(const Content& content);
    void drawLine(const CostChart& chart, const std::vector<std::size_t>& front);
    void drawIntervals(const CostChart& chart);
    void scaleAxes(const CostChart& chart);
    void colour(const QPalette& palette, bool stale);

    QCustomPlot& plot_;
    QCPGraph* all_; ///< carries the intervals, draws nothing itself
    QCPErrorBars* intervals_;
    QCPGraph* line_; ///< draws the front
    Dots beaten_;
    Dots ties_;
    Dots front_;
    QCPGraph* current_;
    QCPGraph* selected_;
    QSharedPointer<AxisTicks> errors_;
};

} // namespace patina
