// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/color_area.h"

#include <algorithm>

#include <QKeyEvent>
#include <QMouseEvent>

namespace patina {

ColorArea::ColorArea(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
}

void ColorArea::setPoint(const QPointF& point) {
    point_ = point;
    update();
}

QPointF ColorArea::pointAt(const QPointF& pixel) const {
    return {std::clamp(pixel.x() / std::max(1, width() - 1), 0.0, 1.0),
            std::clamp(1.0 - pixel.y() / std::max(1, height() - 1), 0.0, 1.0)};
}

void ColorArea::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    isDragging_ = true;
    startPoint_ = point_;
    Q_EMIT dragBegan();
    Q_EMIT moved(pointAt(event->position()));
}

void ColorArea::mouseMoveEvent(QMouseEvent* event) {
    if (isDragging_) {
        Q_EMIT moved(pointAt(event->position()));
    }
}

void ColorArea::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && std::exchange(isDragging_, false)) {
        Q_EMIT dragEnded();
    }
}

void ColorArea::nudge(double x, double y) {
    Q_EMIT moved({std::clamp(point_.x() + x, 0.0, 1.0), std::clamp(point_.y() + y, 0.0, 1.0)});
}

void ColorArea::keyPressEvent(QKeyEvent* event) {
    constexpr double step = 0.01;
    switch (event->key()) {
    case Qt::Key_Escape:
        if (std::exchange(isDragging_, false)) {
            Q_EMIT moved(startPoint_);
            Q_EMIT dragEnded();
        } else {
            event->ignore(); // closes the popup
        }
        return;
    case Qt::Key_Left:
        return nudge(-step, 0.0);
    case Qt::Key_Right:
        return nudge(step, 0.0);
    case Qt::Key_Up:
        return nudge(0.0, step);
    case Qt::Key_Down:
        return nudge(0.0, -step);
    default:
        event->ignore();
    }
}

} // namespace patina
