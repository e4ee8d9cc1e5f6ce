// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/vertical_title.h"

#include <QPainter>

namespace patina {

VerticalTitle::VerticalTitle(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    hide();
}

void VerticalTitle::setText(const QString& text) {
    text_ = text;
    setToolTip(text);
    setAccessibleName(text);
    setVisible(!text.isEmpty());
    update();
}

QSize VerticalTitle::sizeHint() const {
    return {fontMetrics().height(), 0};
}

void VerticalTitle::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRect within = contentsRect();
    painter.translate(0, within.bottom() + 1);
    painter.rotate(-90.0);
    const QRect room(0, 0, within.height(), within.width());
    painter.drawText(room, Qt::AlignCenter,
                     fontMetrics().elidedText(text_, Qt::ElideRight, room.width()));
}

} // namespace patina
