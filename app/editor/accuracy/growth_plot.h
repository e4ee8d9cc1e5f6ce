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

/// Time against how many there are of something, both on log axes: what was measured, how sure it
/// is, and the law as a line; below it the law in words.
class GrowthPlot : public PlotWidget {
    Q_OBJECT

  public:
    explicit GrowthPlot(ScalingCurve::Axis axis, QWidget* parent = nullptr);

    /// Nothing: that is not measured yet.
    void setCurve(const std::optional<ScalingCurve>& curve, bool stale);

    QString law() const;

    /// "pixels", "lights", "objects".
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
