// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "accuracy/plot_widget.h"
#include "measure/match/model_matches.h"

class QCPGraph;
class QCustomPlot;

namespace patina {

/// Draws fitted models as points, the time of a pixel against the relative error on log axes, with
/// the front as a line. The pointer reads a point, and a click picks it.
class MatchPlot : public PlotWidget {
  public:
    /// `pick` is called with the index of the match that was clicked.
    explicit MatchPlot(std::function<void(int match)> pick, QWidget* parent = nullptr);

    /// Shows the models whose time is known; a line is at the relative error `within`.
    void setMatches(const ModelMatches& matches, double within, bool stale);

    /// Returns where a match is drawn, in pixels of this widget.
    QPoint placeOf(std::size_t match) const;

    /// Returns what the pointer reads at a place; empty beside the points.
    QString readingAt(const QPoint& place) const;

    QSize sizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void draw() override;
    void fitAxes();
    int matchAt(const QPoint& place) const; ///< is -1 beside the points

    std::function<void(int match)> pick_;
    ModelMatches matches_;
    double within_ = 0.0;
    bool stale_ = false;
    QCustomPlot* plot_;
    QCPGraph* front_;  ///< is a line through the points of the front
    QCPGraph* beaten_; ///< has the other points
    QCPGraph* limit_;
};

} // namespace patina
