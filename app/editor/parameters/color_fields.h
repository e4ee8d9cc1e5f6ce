// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/color_area.h"

namespace patina {

/// Shows saturation (x) and brightness (y) of one hue, as a screen shows them.
class SaturationField : public ColorArea {
    Q_OBJECT

  public:
    explicit SaturationField(QWidget* parent = nullptr);

    void setHue(double hue);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    double hue_ = 0.0;
};

/// Shows all hues, along x.
class HueStrip : public ColorArea {
    Q_OBJECT

  public:
    explicit HueStrip(QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace patina
