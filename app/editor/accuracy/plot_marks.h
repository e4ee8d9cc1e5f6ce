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

/// Draws a chart of costs in a plot: points, their intervals, the front, rings, axes.
class PlotMarks {
  public:
    /// The plot owns what is made in it.
    explicit PlotMarks(QCustomPlot& plot);

    /// Holds what is to be drawn, and in which colours.
    struct Content {
        const CostChart& chart;
        int current = -1;  ///< in a ring of the text's colour
        int selected = -1; ///< in a ring of the highlight
        bool stale = false;
    };
    void draw(const Content& content, const QPalette& palette);

    /// Points of one standing.
    struct Dots {
        QCPGraph* known;  ///< discs
        QCPGraph* bounds; ///< arrows, where times are bounds

        void colour(const QColor& edge, const QColor& inside) const;
    };

    /// Returns where a point is drawn, in the plot.
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
    QCPGraph* line_; ///< of the front
    Dots beaten_;
    Dots ties_;
    Dots front_;
    QCPGraph* current_;
    QCPGraph* selected_;
    QSharedPointer<AxisTicks> errors_;
};

} // namespace patina
