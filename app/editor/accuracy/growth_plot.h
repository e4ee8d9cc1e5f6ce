// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "accuracy/plot_widget.h"
#include "measure/cost/scaling_curve.h"

class QCPErrorBars;
class QCPGraph;
class QCustomPlot;
class QLabel;

namespace patina {

/// Draws time against a number of pixels, lights or objects on log axes: the samples with their
/// intervals, and the fitted law as a line and, below the plot, in words.
class GrowthPlot : public PlotWidget {
    Q_OBJECT

  public:
    explicit GrowthPlot(ScalingCurve::Axis axis, QWidget* parent = nullptr);

    /// Shows a curve; the plot is empty without one.
    void setCurve(const std::optional<ScalingCurve>& curve, bool stale);

    QString law() const;

    /// Returns what an axis counts: "pixels", "lights" or "objects".
    static QString nameOf(ScalingCurve::Axis axis);

  private:
    void draw() override;
    void drawLaw();
    void scaleAxes();
    void colour();

    ScalingCurve curve_;
    bool stale_ = false;
    QCustomPlot* plot_;
    QCPGraph* line_;
    QCPGraph* points_;
    QCPErrorBars* intervals_;
    QLabel* law_;
};

} // namespace patina
