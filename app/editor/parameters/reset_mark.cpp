// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/reset_mark.h"

#include <QPainter>
#include <QPainterPath>

#include "parameters/mark_size.h"

namespace patina {

ResetMark::ResetMark(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::NoFocus); // Backspace and the row's menu do the same from the keyboard
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    QSizePolicy policy = sizePolicy();
    policy.setRetainSizeWhenHidden(true); // nothing may jump when a value changes
    setSizePolicy(policy);
}

QSize ResetMark::sizeHint() const {
    return markSize(*this);
}

void ResetMark::enterEvent(QEnterEvent*) {
    update();
}
void ResetMark::leaveEvent(QEvent*) {
    update();
}

void ResetMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double radius = width() * 0.28;
    const QPointF centre = QRectF(rect()).center();
    const QColor color = palette().color(underMouse() ? QPalette::WindowText : QPalette::Highlight);
    painter.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap));
    // Three quarters of a circle that ends at the left in an arrow head.
    const QRectF circle(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius);
    constexpr int sixteenths = 16; // QPainter counts angles in sixteenths of a degree
    painter.drawArc(circle, 150 * sixteenths, -290 * sixteenths);
    const QPointF tip(centre.x() - radius * 0.87, centre.y() - radius * 0.5);
    QPainterPath head(tip + QPointF(-0.45 * radius, 0.75 * radius));
    head.lineTo(tip + QPointF(-0.35 * radius, -0.55 * radius));
    head.lineTo(tip + QPointF(0.75 * radius, 0.35 * radius));
    head.closeSubpath();
    painter.fillPath(head, color);
}

} // namespace patina
