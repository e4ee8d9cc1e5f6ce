// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "accuracy/measure_page.h"
#include "measure/cost/scaling_sweep.h"

namespace patina {

class GrowthPlot;

/// Shows how the time of a frame grows with its pixels, lights and objects, measured on the current
/// object with its material.
class ScalingPage : public MeasurePage {
    Q_OBJECT

  public:
    ScalingPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn);

    /// Starts a measurement. Does nothing while this or another page measures, or without an
    /// object.
    void measure(ScalingSweep::Options options);

    const std::vector<ScalingCurve>& curves() const { return numbers<std::vector<ScalingCurve>>(); }

  protected:
    void startMeasuring() override;
    MeasuredSubject subject() const override;
    void showNumbers(bool stale) override;
    QByteArray bytesFor(const QString& ending) const override;

  private:
    QWidget* plots_;
    std::array<GrowthPlot*, 3> plot_; ///< are indexed by ScalingCurve::Axis
};

} // namespace patina
