// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "lobe/lobe_plot_widget.h"
#include "measure/lobe/lobe_scale.h"

namespace patina {

/// Draws reflectances in the plane of incidence as a half disc, the light at the left. A drag turns
/// the light, as do the left and right keys by a degree.
class PolarPlot final : public LobePlotWidget {
    Q_OBJECT

  public:
    explicit PolarPlot(QWidget* parent = nullptr);

    void setScale(LobeScale scale);
    void setLight(double degrees);
    double light() const { return light_; }

    /// Marks the angle of a viewer, in degrees as abscissaAt() returns them; none without one.
    void setViewer(std::optional<double> degrees);

    /// Returns where an angle at the edge of the disc is drawn, in pixels of this widget.
    QPointF edgeAt(double degrees) const;

  Q_SIGNALS:
    void lightTurned(double degrees);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    double abscissaAt(const QPointF& place) const override;
    QString unit() const override;
    void draw() override;

  private:
    void addDisc(double largest);
    void addViewer();
    void turnTo(double degrees);
    void fitRanges() override;

    LobeScale scale_ = LobeScale::Linear;
    double light_ = 45.0; ///< degrees from the normal
    std::optional<double> viewer_;
};

} // namespace patina
