// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/warning_mark.h"

#include <QPainter>
#include <QPolygonF>

#include "parameters/mark_size.h"

namespace patina {

namespace {

const QColor amber(214, 150, 20);
const QColor ink(40, 28, 0);

} // namespace

WarningMark::WarningMark(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    hide();
}

void WarningMark::setWarning(const QString& warning) {
    setToolTip(warning);
    setAccessibleName(warning);
    setVisible(!warning.isEmpty());
}

QSize WarningMark::sizeHint() const {
    return markSize(*this);
}

void WarningMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = width();
    painter.translate(0.0, (height() - side) / 2.0);
    const QPolygonF triangle({QPointF(side * 0.5, side * 0.12), QPointF(side * 0.94, side * 0.88),
                              QPointF(side * 0.06, side * 0.88)});
    painter.setPen(QPen(amber, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(amber);
    painter.drawPolygon(triangle);
    painter.setPen(QPen(ink, side * 0.11, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(side * 0.5, side * 0.4), QPointF(side * 0.5, side * 0.62));
    painter.drawPoint(QPointF(side * 0.5, side * 0.77));
}

} // namespace patina
