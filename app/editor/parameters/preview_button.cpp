// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/preview_button.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace patina {

PreviewButton::PreviewButton(Painting painting, QWidget* parent)
    : QAbstractButton(parent), painting_(std::move(painting)) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

QSize PreviewButton::sizeHint() const {
    const int line = fontMetrics().height();
    return {line * 6, line * 2};
}

void PreviewButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        click();
        return;
    }
    QAbstractButton::keyPressEvent(event);
}

void PreviewButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(isEnabled() ? 1.0 : 0.4);
    const QRectF frame = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    QPainterPath inside;
    inside.addRoundedRect(frame, 3.0, 3.0);
    painter.setClipPath(inside);
    painting_(painter, frame);
    painter.setClipping(false);
    QColor edge = palette().color(hasFocus() ? QPalette::Highlight : QPalette::WindowText);
    edge.setAlphaF(hasFocus() ? 1.0f : 0.35f);
    painter.setPen(QPen(edge, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(inside);
}

} // namespace patina
