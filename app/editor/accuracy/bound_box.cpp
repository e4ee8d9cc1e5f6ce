// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/bound_box.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"

namespace patina {
namespace {

struct Limits {
    double min;
    double max;
};
constexpr Limits millisecondLimits{1e-6, 1e7};
constexpr Limits shareLimits{1e-7, 10.0};

QString digitsOf(double number) {
    return QString::fromStdString(shortestText(static_cast<float>(number)));
}

/// Returns the shorter of "1/255" and "0.4 %".
QString textOfShare(double share) {
    const QString percents = QStringLiteral("%1 %").arg(digitsOf(100.0 * share));
    const double parts = std::round(1.0 / share);
    constexpr double rounding = 1e-9;
    if (std::abs(parts * share - 1.0) > rounding) {
        return percents;
    }
    const QString fraction = QStringLiteral("1/%1").arg(parts, 0, 'f', 0);
    return fraction.size() < percents.size() ? fraction : percents;
}

/// Moves a value by `steps` units of its second significant digit; the result stays positive.
double further(double value, double steps) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::max(std::round(value / step) + steps, 1.0) * step;
}

} // namespace

BoundBox::BoundBox(Of of, double usual, QWidget* parent)
    : NumberBox(2, of == Of::Milliseconds ? QStringLiteral("ms") : QString(), parent), of_(of) {
    connect(this, &NumberBox::typed, this, &BoundBox::take);
    connect(this, &NumberBox::stepped, this,
            [this](double steps) { take(further(value(), steps)); });
    setValue(usual);
}

void BoundBox::take(double wanted) {
    const Limits& limits = of_ == Of::Milliseconds ? millisecondLimits : shareLimits;
    const double inside = std::clamp(wanted, limits.min, limits.max);
    if (inside != value()) {
        setValue(inside);
        Q_EMIT valueChanged();
    }
}

QString BoundBox::textOf(double value) const {
    // The field is made before it has a value.
    return of_ == Of::Share && value > 0.0 ? textOfShare(value) : NumberBox::textOf(value);
}

} // namespace patina
