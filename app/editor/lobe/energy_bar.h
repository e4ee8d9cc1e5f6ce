// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "measure/lobe/albedo_curve.h"

namespace patina {

/// Shows what a material reflects of all the light as a bar: the range over the light's angle, a
/// line at what it reflects of an even sky, and red what is above 1.
class EnergyBar : public QWidget {
    Q_OBJECT

  public:
    explicit EnergyBar(QWidget* parent = nullptr);

    /// Nothing: the bar is empty.
    void setRange(const std::optional<EnergyRange>& range);

    /// Says the numbers in words; empty without a range.
    QString text() const;

    /// Says that more light is reflected than arrives, in some channel from some angle.
    bool isAboveOne() const;

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::optional<EnergyRange> range_;
};

} // namespace patina
