// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/lock_mark.h"

#include <QPainter>
#include <QPainterPath>

#include "parameters/mark_size.h"

namespace patina {

LockMark::LockMark(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::NoFocus); // the row's menu does the same from the keyboard
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    hide();
}

QSize LockMark::sizeHint() const {
    return markSize(*this);
}

void LockMark::enterEvent(QEnterEvent*) {
    update();
}
void LockMark::leaveEvent(QEvent*) {
    update();
}

void LockMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = width();
    painter.translate(0.0, (height() - side) / 2.0);
    const QColor color = palette().color(underMouse() ? QPalette::WindowText : QPalette::Highlight);
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

} // namespace patina
