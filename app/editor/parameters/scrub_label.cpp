// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/scrub_label.h"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

namespace patina {

ScrubLabel::ScrubLabel(const QString& text, QWidget* parent) : QLabel(text, parent) {}

void ScrubLabel::setDraggable() {
    isDraggable_ = true;
    setCursor(Qt::SizeHorCursor);
}

void ScrubLabel::mousePressEvent(QMouseEvent* event) {
    if (!isDraggable_ || event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    drag_ = Drag::Pressed;
    pressed_ = last_ = event->globalPosition().x();
}

/// A drag begins after a few pixels, so that a double click stays one.
void ScrubLabel::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->globalPosition().x();
    const double enough = 0.5 * QApplication::startDragDistance();
    if (drag_ == Drag::Pressed && std::abs(x - pressed_) >= enough) {
        begin();
    }
    if (drag_ == Drag::Scrubbing && x != last_) {
        Q_EMIT scrubbed(x - last_, event->modifiers());
        last_ = x;
    }
}

void ScrubLabel::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        end();
    }
}

void ScrubLabel::mouseDoubleClickEvent(QMouseEvent* event) {
    event->ignore(); // it resets, which is the row's
}

void ScrubLabel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && drag_ == Drag::Scrubbing) {
        Q_EMIT scrubCancelled();
        end();
    }
}

void ScrubLabel::hideEvent(QHideEvent* event) {
    QLabel::hideEvent(event);
    end(); // no release comes to a hidden widget
}

void ScrubLabel::begin() {
    drag_ = Drag::Scrubbing;
    grabKeyboard(); // Esc is its own meanwhile, whatever has the focus
    Q_EMIT scrubBegan();
}

void ScrubLabel::end() {
    const Drag drag = std::exchange(drag_, Drag::None);
    if (drag == Drag::Scrubbing) {
        releaseKeyboard();
        Q_EMIT scrubEnded();
    }
}

} // namespace patina
