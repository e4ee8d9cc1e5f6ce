// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/color_fields.h"

#include <algorithm>

#include <QLinearGradient>
#include <QPainter>

namespace patina {

namespace {

QColor pureHue(double hue) {
    return QColor::fromHsvF(static_cast<float>(hue), 1.0f, 1.0f);
}

/// Paints a ring that stands out on any colour.
void paintRing(QPainter& painter, const QPointF& centre, double radius) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 3.0));
    painter.drawEllipse(centre, radius, radius);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.drawEllipse(centre, radius, radius);
}

void paintFocus(QPainter& painter, const QWidget& widget) {
    if (widget.hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(widget.palette().color(QPalette::Highlight), 2.0));
        painter.drawRect(QRectF(widget.rect()).adjusted(1.0, 1.0, -1.0, -1.0));
    }
}

} // namespace

SaturationField::SaturationField(QWidget* parent) : ColorArea(parent) {
    setAccessibleName(tr("Saturation and brightness"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SaturationField::setHue(double hue) {
    hue_ = hue;
    update();
}

QSize SaturationField::sizeHint() const {
    const int line = fontMetrics().height();
    return {line * 14, line * 9};
}

void SaturationField::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QLinearGradient saturation(0.0, 0.0, width(), 0.0);
    saturation.setColorAt(0.0, Qt::white);
    saturation.setColorAt(1.0, pureHue(hue_));
    painter.fillRect(rect(), saturation);
    QLinearGradient brightness(0.0, 0.0, 0.0, height());
    brightness.setColorAt(0.0, QColor(0, 0, 0, 0));
    brightness.setColorAt(1.0, Qt::black);
    painter.fillRect(rect(), brightness);
    paintFocus(painter, *this);
    constexpr double radius = 6.0;
    const auto inside = [](double share, int length) { // the whole ring stays in sight
        return std::clamp(share * length, radius + 2.0, length - radius - 2.0);
    };
    paintRing(painter, {inside(point().x(), width()), inside(1.0 - point().y(), height())}, radius);
}

HueStrip::HueStrip(QWidget* parent) : ColorArea(parent) {
    setAccessibleName(tr("Hue"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize HueStrip::sizeHint() const {
    const int line = fontMetrics().height();
    return {line * 14, line + 4};
}

void HueStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QLinearGradient hues(0.0, 0.0, width(), 0.0);
    constexpr int corners = 6; // of the hue circle: red, yellow, green, cyan, blue, magenta
    for (int i = 0; i <= corners; ++i) {
        const double share = static_cast<double>(i) / corners;
        hues.setColorAt(share, pureHue(i == corners ? 0.0 : share));
    }
    painter.fillRect(rect(), hues);
    paintFocus(painter, *this);
    const double radius = height() / 2.0 - 2.0;
    const double x = std::clamp(point().x() * width(), radius + 2.0, width() - radius - 2.0);
    paintRing(painter, {x, height() / 2.0}, radius);
}

} // namespace patina
