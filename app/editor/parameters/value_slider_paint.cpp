// SPDX-License-Identifier: GPL-3.0-or-later
// How a value slider looks.
#include <algorithm>

#include <QPainter>

#include "parameters/value_slider.h"

namespace patina {

namespace {

QColor mixed(const QColor& from, const QColor& to, double share) {
    const auto mix = [share](float a, float b) { return static_cast<float>(a + (b - a) * share); };
    return QColor::fromRgbF(mix(from.redF(), to.redF()), mix(from.greenF(), to.greenF()),
                            mix(from.blueF(), to.blueF()));
}

struct Colors {
    QColor groove;
    QColor filled;
    QColor handle;
    QColor edge;
    QColor tick;
};

Colors colorsOf(const QWidget& widget, bool isDragging) {
    const QPalette& palette = widget.palette();
    const QColor window = palette.color(QPalette::Window);
    const QColor text = palette.color(QPalette::WindowText);
    const QColor accent = palette.color(QPalette::Active, QPalette::Highlight);
    const bool isEnabled = widget.isEnabled();
    const QColor filled = isEnabled ? accent : mixed(window, text, 0.3);
    const QColor handle =
        isEnabled ? mixed(window, text, isDragging ? 0.95 : 0.8) : mixed(window, text, 0.35);
    return {mixed(window, text, 0.18), filled, handle, window, mixed(window, text, 0.45)};
}

void paintBar(QPainter& painter, double from, double to, double middle, double thickness,
              const QColor& color) {
    const QRectF bar(std::min(from, to), middle - thickness / 2.0, std::abs(to - from), thickness);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(bar, thickness / 2.0, thickness / 2.0);
}

} // namespace

void ValueSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Colors colors = colorsOf(*this, isDragging_);
    const double middle = height() / 2.0;
    const double thickness = std::max(3.0, std::round(radius() * 0.6));
    const double start = pixelOf(range_.lower());
    const double end = pixelOf(range_.upper());
    const double zero = range_.lower() < 0.0 ? pixelOf(0.0) : start;
    const double handle = pixelOf(value_);

    paintBar(painter, start, end, middle, thickness, colors.groove);
    paintBar(painter, zero, handle, middle, thickness, colors.filled);

    // The default's place, and where the usual range ended before the slider was widened.
    const auto tick = [&](double value, double share) {
        const double pixel = pixelOf(value);
        const double reach = radius() * share;
        painter.setPen(QPen(colors.tick, 1.2));
        painter.drawLine(QPointF(pixel, middle - reach), QPointF(pixel, middle + reach));
    };
    tick(defaultValue_, 0.55);
    if (range_.isWidenedAbove()) {
        tick(range_.softMax(), 1.0);
    }
    if (range_.isWidenedBelow()) {
        tick(range_.softMin(), 1.0);
    }

    if (hasFocus()) {
        painter.setPen(QPen(colors.filled, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(handle, middle), radius(), radius());
    }
    painter.setPen(QPen(colors.edge, 1.5));
    painter.setBrush(colors.handle);
    painter.drawEllipse(QPointF(handle, middle), radius() * 0.75, radius() * 0.75);
}

} // namespace patina
