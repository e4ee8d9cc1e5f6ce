// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/axis_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QFontMetricsF>

namespace patina {
namespace {

constexpr double evenBelow = 8.0;   ///< ratio of the axis' ends below which ticks are evenly spaced
constexpr int maxEven = 6;          ///< is the greatest number of ticks at even distances
constexpr double gap = 8.0;         ///< pixels between two labels
constexpr double besideAxes = 90.0; ///< pixels by which a plot is longer than its axis, at most

/// Is the ratio to the named tick below which others are left out.
constexpr double clearOfBegin = 2.5;

QVector<double> decades(const QCPRange& range, const QVector<double>& steps, int stride) {
    QVector<double> ticks;
    const int first = static_cast<int>(std::floor(std::log10(range.lower)));
    const int last = static_cast<int>(std::floor(std::log10(range.upper)));
    for (int power = first; power <= last; ++power) {
        for (const double step : steps) {
            const double tick = step * std::pow(10.0, power);
            if (power % stride == 0 && tick >= range.lower && tick <= range.upper) {
                ticks << tick;
            }
        }
    }
    return ticks;
}

/// Returns the smallest of 1, 2, 5, 10 times a power of ten that is not below a number.
double roundStep(double number) {
    const double decade = std::pow(10.0, std::floor(std::log10(number)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (number <= step * decade) {
            return step * decade;
        }
    }
    return 10.0 * decade;
}

QVector<double> evenly(const QCPRange& range, int count) {
    const double step = roundStep((range.upper - range.lower) / count);
    QVector<double> ticks;
    for (double n = std::ceil(range.lower / step); n * step <= range.upper; ++n) {
        ticks << n * step;
    }
    return ticks;
}

} // namespace

AxisTicks::AxisTicks(const QCPAxis& axis, Text text) : axis_(axis), text_(text) {}

void AxisTicks::begin(double at, const QString& name) {
    begin_ = at;
    beginName_ = name;
}

QVector<double> AxisTicks::createTickVector(double, const QCPRange& range) {
    if (range.upper < evenBelow * range.lower) {
        for (int count = maxEven; count > 1; --count) {
            const QVector<double> ticks = withBegin(evenly(range, count));
            if (haveRoom(ticks, range)) {
                return ticks;
            }
        }
    } else {
        for (const QVector<double>& steps : std::array<QVector<double>, 2>{{{1, 2, 5}, {1, 3}}}) {
            const QVector<double> ticks = withBegin(decades(range, steps, 1));
            if (haveRoom(ticks, range)) {
                return ticks;
            }
        }
    }
    const int all = static_cast<int>(std::ceil(std::log10(range.upper / range.lower)));
    for (int stride = 1; stride < all; ++stride) {
        const QVector<double> ticks = withBegin(decades(range, {1.0}, stride));
        if (haveRoom(ticks, range)) {
            return ticks;
        }
    }
    return withBegin({});
}

QVector<double> AxisTicks::withBegin(QVector<double> ticks) const {
    if (begin_ > 0.0) {
        ticks.removeIf([this](double tick) { return tick < clearOfBegin * begin_; });
        ticks.prepend(begin_);
    }
    return ticks;
}

/// Measures with the size of the whole plot, since that of the axis depends on its labels.
bool AxisTicks::haveRoom(const QVector<double>& ticks, const QCPRange& range) const {
    const bool isWide = axis_.orientation() == Qt::Horizontal;
    const QSize size = axis_.parentPlot()->viewport().size();
    const double length = std::max((isWide ? size.width() : size.height()) - besideAxes, 1.0);
    const double perLog = length / std::log(range.upper / range.lower);
    const QFontMetricsF metrics(axis_.tickLabelFont());
    const auto extent = [&](double tick) {
        return isWide ? metrics.horizontalAdvance(label(tick)) : metrics.height();
    };
    for (qsizetype i = 1; i < ticks.size(); ++i) {
        const double apart = perLog * std::log(ticks[i] / ticks[i - 1]);
        if (apart < 0.5 * (extent(ticks[i - 1]) + extent(ticks[i])) + (isWide ? gap : 0.0)) {
            return false;
        }
    }
    return true;
}

QString AxisTicks::label(double tick) const {
    return tick == begin_ ? beginName_ : text_(tick);
}

QString AxisTicks::getTickLabel(double tick, const QLocale&, QChar, int) {
    return label(tick);
}

} // namespace patina
