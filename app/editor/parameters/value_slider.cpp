// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/value_slider.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "parameters/value_slider_accessible.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

struct Colors {
    QColor groove;
    QColor filled;
    QColor handle;
    QColor edge;
    QColor tick;
};

Colors colorsOf(const QWidget& widget, bool isDragging) {
    const QPalette& palette = widget.palette();
    const QColor window = palette.color(QPalette::Window);
    const QColor text = palette.color(QPalette::WindowText);
    const QColor accent = palette.color(QPalette::Active, QPalette::Highlight);
    const bool isEnabled = widget.isEnabled();
    const QColor filled = isEnabled ? accent : mixed(window, text, 0.3);
    const QColor handle =
        isEnabled ? mixed(window, text, isDragging ? 0.95 : 0.8) : mixed(window, text, 0.35);
    return {mixed(window, text, 0.18), filled, handle, window, mixed(window, text, 0.45)};
}

void paintBar(QPainter& painter, double from, double to, double middle, double thickness,
              const QColor& color) {
    const QRectF bar(std::min(from, to), middle - thickness / 2.0, std::abs(to - from), thickness);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(bar, thickness / 2.0, thickness / 2.0);
}

} // namespace

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

void ValueSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Colors colors = colorsOf(*this, isDragging_);
    const double middle = height() / 2.0;
    const double thickness = std::max(3.0, std::round(radius() * 0.6));
    const double start = pixelOf(range_.lower());
    const double end = pixelOf(range_.upper());
    const double zero = range_.lower() < 0.0 ? pixelOf(0.0) : start;
    const double handle = pixelOf(value_);

    paintBar(painter, start, end, middle, thickness, colors.groove);
    paintBar(painter, zero, handle, middle, thickness, colors.filled);

    // The default's place, and where the usual range ended before the slider was widened.
    const auto tick = [&](double value, double share) {
        const double pixel = pixelOf(value);
        const double reach = radius() * share;
        painter.setPen(QPen(colors.tick, 1.2));
        painter.drawLine(QPointF(pixel, middle - reach), QPointF(pixel, middle + reach));
    };
    tick(defaultValue_, 0.55);
    if (range_.isWidenedAbove()) {
        tick(range_.softMax(), 1.0);
    }
    if (range_.isWidenedBelow()) {
        tick(range_.softMin(), 1.0);
    }

    if (hasFocus()) {
        painter.setPen(QPen(colors.filled, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(handle, middle), radius(), radius());
    }
    painter.setPen(QPen(colors.edge, 1.5));
    painter.setBrush(colors.handle);
    painter.drawEllipse(QPointF(handle, middle), radius() * 0.75, radius() * 0.75);
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
