// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/row_mark.h"

#include <QPainter>
#include <QPainterPath>

#include "parameters/mark_size.h"

namespace patina {

RowMark::RowMark(Drawing drawing, QWidget* parent) : QAbstractButton(parent), drawing_(drawing) {
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    hide();
}

QSize RowMark::sizeHint() const {
    return markSize(*this);
}

void RowMark::enterEvent(QEnterEvent*) {
    update();
}

void RowMark::leaveEvent(QEvent*) {
    update();
}

void RowMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0.0, (height() - width()) / 2.0);
    drawing_(painter, width(),
             palette().color(underMouse() ? QPalette::WindowText : QPalette::Highlight));
}

void drawPadlock(QPainter& painter, double side, const QColor& color) {
    painter.setPen(QPen(color, side * 0.09, Qt::SolidLine, Qt::FlatCap));
    QPainterPath shackle(QPointF(side * 0.34, side * 0.5));
    shackle.lineTo(side * 0.34, side * 0.36);
    shackle.arcTo(QRectF(side * 0.34, side * 0.2, side * 0.32, side * 0.32), 180.0, -180.0);
    shackle.lineTo(side * 0.66, side * 0.5);
    painter.drawPath(shackle);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(side * 0.24, side * 0.47, side * 0.52, side * 0.38), side * 0.06,
                            side * 0.06);
}

/// Three quarters of a circle end at the left in an arrow head.
void drawResetArrow(QPainter& painter, double side, const QColor& color) {
    const double radius = side * 0.28;
    const QPointF centre(side / 2.0, side / 2.0);
    painter.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap));
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
