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

    /// Shows what is reflected, per channel. Where a luminance is given its numbers are shown, as
    /// of curves that are the luminance.
    void setRange(const EnergyRange& range, const std::optional<EnergyRange>& luminance = {});

    /// Empties the bar; the text says why.
    void setNothing(const QString& why);

    /// Sets whose energy it is, which the text says; empty where that is plain.
    void setName(const QString& name);

    /// Says the numbers in words, or why there are none.
    QString text() const;

    /// Says that more light is reflected than arrives, in some channel from some angle.
    bool isAboveOne() const;

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void refresh();
    void paintRange(QPainter& painter, const QRectF& bar) const;

    const EnergyRange& shown() const { return luminance_ ? *luminance_ : *range_; }
    QString rangeText() const;

    std::optional<EnergyRange> range_;
    std::optional<EnergyRange> luminance_;
    QString why_;
    QString name_;
};

} // namespace patina
