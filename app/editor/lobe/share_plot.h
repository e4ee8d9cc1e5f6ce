// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lobe/lobe_plot_widget.h"

namespace patina {

/// Draws shares of the light over its angle from the normal, with 1 marked where it is exceeded,
/// and angles that have a name; the right axis of a Fresnel plot reads what is transmitted. Errors
/// of single precision are drawn over the viewer's angle.
class SharePlot final : public LobePlotWidget {
    Q_OBJECT

  public:
    explicit SharePlot(LobePlot plot, QWidget* parent = nullptr);

  protected:
    double degreesAt(const QPointF& place) const override;
    QString unit() const override;
    void draw() override;

  private:
    void addMarks(double top);

    LobePlot kind_;
};

} // namespace patina
