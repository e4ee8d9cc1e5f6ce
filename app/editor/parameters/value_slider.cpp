// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/value_slider.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "parameters/value_slider_accessible.h"

namespace patina {

ValueSlider::ValueSlider(QWidget* parent) : QWidget(parent) {
    installValueSliderAccessibility();
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ValueSlider::setRange(const SliderRange& range) {
    range_ = range;
    update();
}

void ValueSlider::setValue(double value) {
    if (value != value_) {
        value_ = value;
        announceValue();
        update();
    }
}

void ValueSlider::setDefaultValue(double value) {
    defaultValue_ = value;
    update();
}

void ValueSlider::announceValue() {
    if (QAccessible::isActive()) {
        QAccessibleValueChangeEvent event(this, value_);
        QAccessible::updateAccessibility(&event);
    }
}

QSize ValueSlider::sizeHint() const {
    const int line = fontMetrics().height();
    return {line * 8, line + 6};
}

QSize ValueSlider::minimumSizeHint() const {
    const int line = fontMetrics().height();
    return {line * 3, line + 6};
}

double ValueSlider::radius() const {
    return std::round(fontMetrics().height() * 0.45);
}

double ValueSlider::length() const {
    return std::max(1.0, width() - 2.0 * radius() - 2.0);
}

double ValueSlider::pixelOf(double value) const {
    const double pixel = radius() + 1.0 + range_.positionOf(value) * length();
    return isRightToLeft() ? width() - pixel : pixel;
}

double ValueSlider::shareAt(double pixel) const {
    const double fromStart = isRightToLeft() ? width() - pixel : pixel;
    return (fromStart - radius() - 1.0) / length();
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    isDragging_ = true;
    startValue_ = value_;
    lastPixel_ = event->position().x();
    share_ = range_.positionOf(value_);
    Q_EMIT dragBegan();
    const bool onHandle = std::abs(lastPixel_ - pixelOf(value_)) <= radius() + 1.0;
    if (!onHandle && !(event->modifiers() & Qt::ShiftModifier)) {
        share_ = shareAt(lastPixel_);
        moveTo(share_, event->modifiers());
    }
    update();
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
    if (!isDragging_) {
        return;
    }
    const double way = shareAt(event->position().x()) - shareAt(lastPixel_);
    lastPixel_ = event->position().x();
    share_ += way * fineness(event->modifiers());
    moveTo(share_, event->modifiers());
}

void ValueSlider::moveTo(double share, Qt::KeyboardModifiers modifiers) {
    const double inside = std::clamp(share, 0.0, 1.0);
    const double pixel = 1.0 / length();
    const double span = pixel * fineness(modifiers);
    const double wanted = modifiers & Qt::ControlModifier
                              ? range_.snappedValueAt(inside, snapPixels * span)
                              : range_.tidyValueAt(inside, span);
    if (wanted != value_) {
        Q_EMIT moved(wanted);
    }
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        finishDrag();
    }
}

void ValueSlider::finishDrag() {
    if (isDragging_) {
        isDragging_ = false;
        Q_EMIT dragEnded();
        update();
    }
}

bool ValueSlider::cancelDrag() {
    if (!isDragging_) {
        return false;
    }
    Q_EMIT moved(startValue_);
    finishDrag();
    return true;
}

/// The keys a focused slider uses are its own, even where the window has a shortcut on them.
bool ValueSlider::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        constexpr std::array keys{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,
                                  Qt::Key_Home, Qt::Key_End,   Qt::Key_PageUp, Qt::Key_PageDown};
        const auto* press = static_cast<QKeyEvent*>(event);
        const bool isOurs = std::find(keys.begin(), keys.end(), press->key()) != keys.end() ||
                            (press->key() == Qt::Key_Escape && isDragging_);
        const bool isPlain = !(press->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
        event->setAccepted(isOurs && isPlain);
        return event->isAccepted();
    }
    return QWidget::event(event);
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
    const double forward = (isRightToLeft() ? -1.0 : 1.0) * fineness(event->modifiers());
    if (const std::optional<double> steps = stepsOf(*event)) {
        Q_EMIT stepped(*steps);
        return;
    }
    switch (event->key()) {
    case Qt::Key_Escape:
        if (!cancelDrag()) {
            event->ignore();
        }
        return;
    case Qt::Key_Right:
        Q_EMIT stepped(forward);
        return;
    case Qt::Key_Left:
        Q_EMIT stepped(-forward);
        return;
    case Qt::Key_Home:
        Q_EMIT jumped(range_.softMin());
        return;
    case Qt::Key_End:
        Q_EMIT jumped(range_.softMax());
        return;
    default:
        event->ignore();
    }
}

/// Scrolling past a form must not change it: without focus the wheel belongs to what scrolls.
void ValueSlider::wheelEvent(QWheelEvent* event) {
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    if (const double steps = wheel_.take(*event); steps != 0.0) {
        Q_EMIT stepped(steps);
    }
    event->accept();
}

void ValueSlider::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    wheel_.forget();
    update();
}

void ValueSlider::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void ValueSlider::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    finishDrag(); // no release comes to a hidden widget
}

void ValueSlider::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        updateGeometry();
    }
}

} // namespace patina
