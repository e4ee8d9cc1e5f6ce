// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVector>

#include "accuracy/plot_library.h"

namespace patina {

/// Places ticks of a logarithmic axis at round numbers, as many as have room for their labels: at
/// 1, 2, 5, 10, at 1, 3, 10, or at powers of ten. An axis shorter than a decade has evenly spaced
/// ticks.
class AxisTicks : public QCPAxisTicker {
  public:
    using Text = QString (*)(double number);

    /// Keeps a reference to the axis, which has to live as long as this is in use.
    AxisTicks(const QCPAxis& axis, Text text);

    /// Puts a tick at `at` with the label `name`, where the axis begins; ticks too close to it are
    /// left out.
    void begin(double at, const QString& name);

  protected:
    QVector<double> createTickVector(double step, const QCPRange& range) override;
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;

  private:
    QVector<double> withBegin(QVector<double> ticks) const;
    bool haveRoom(const QVector<double>& ticks, const QCPRange& range) const;
    QString label(double tick) const;

    const QCPAxis& axis_;
    Text text_;
    double begin_ = 0.0; ///< is 0 without a named tick
    QString beginName_;
};

} // namespace patina
