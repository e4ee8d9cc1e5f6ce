// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/handle_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>

namespace patina {
namespace {

constexpr double handleReach = 10.0;     // pixels around a handle at which it is hit
constexpr double awayPixels = 24.0;      // pixels beyond the field at which a handle is removed
constexpr int keyRestMilliseconds = 400; // is longer than a slow key repeat
constexpr double keyStep = 0.01;
constexpr double fineKeyStep = 0.001;

} // namespace

HandleArea::HandleArea(const Limits& limits, QWidget* parent) : QWidget(parent), limits_(limits) {
    setFocusPolicy(Qt::StrongFocus);
    nudging_.setSingleShot(true);
    nudging_.setInterval(keyRestMilliseconds);
    connect(&nudging_, &QTimer::timeout, this, &HandleArea::interactionEnded);
}

void HandleArea::setHandles(const std::vector<Handle>& handles) {
    handles_ = handles;
    if (chosen_ && *chosen_ >= handles_.size()) {
        setChosen(handles_.empty() ? std::nullopt : std::optional(handles_.size() - 1));
    }
    update();
}

void HandleArea::choose(std::size_t index) {
    if (index < handles_.size()) {
        setChosen(index);
    }
}

void HandleArea::setChosen(std::optional<std::size_t> index) {
    chosen_ = index;
    update();
    Q_EMIT chosenChanged();
}

std::optional<std::size_t> HandleArea::handleNear(const QPointF& pixel) const {
    std::optional<std::size_t> nearest;
    double distance = handleReach;
    for (std::size_t i = 0; i < handles_.size(); ++i) {
        const double length = QLineF(pixelOf(handles_[i]), pixel).length();
        if (length < distance || (length == distance && !nearest)) {
            nearest = i;
            distance = length;
        }
    }
    return nearest;
}

/// Returns the place nearest to x between the neighbours of a handle; nothing where they are too
/// close.
std::optional<double> HandleArea::roomFor(double x, std::size_t index) const {
    const double low = index == 0 ? 0.0 : handles_[index - 1].x + limits_.gap;
    const double high = index + 1 < handles_.size() ? handles_[index + 1].x - limits_.gap : 1.0;
    return low <= high ? std::optional(std::clamp(x, low, high)) : std::nullopt;
}

/// Puts the dragged handle as near to where it is wanted as the others allow, also beyond them.
void HandleArea::moveThroughOthers(const Handle& wanted) {
    handles_ = base_;
    const auto begin = handles_.begin();
    std::rotate(begin, begin + static_cast<std::ptrdiff_t>(*dragged_),
                begin + static_cast<std::ptrdiff_t>(*dragged_) + 1);
    std::size_t nearest = *dragged_;
    double x = base_[*dragged_].x;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < handles_.size(); ++i) { // the dragged one stands at i
        const std::optional<double> room = roomFor(wanted.x, i);
        if (room && std::abs(*room - wanted.x) < distance) {
            nearest = i;
            x = *room;
            distance = std::abs(*room - wanted.x);
        }
        if (i + 1 < handles_.size()) {
            std::swap(handles_[i], handles_[i + 1]);
        }
    }
    std::rotate(begin + static_cast<std::ptrdiff_t>(nearest), handles_.end() - 1, handles_.end());
    handles_[nearest] = wanted;
    handles_[nearest].x = x;
    setChosen(nearest);
}

/// Puts a handle among the others and returns its index; returns nothing where there is no room for
/// it.
std::optional<std::size_t> HandleArea::insert(const Handle& handle) {
    const auto after = std::ranges::upper_bound(handles_, handle.x, {}, &Handle::x);
    const bool fits = handles_.size() < limits_.max &&
                      (after == handles_.end() || after->x - handle.x >= limits_.gap) &&
                      (after == handles_.begin() || handle.x - (after - 1)->x >= limits_.gap);
    if (!fits) {
        return std::nullopt;
    }
    const auto place = after - handles_.begin();
    handles_.insert(after, handle);
    return static_cast<std::size_t>(place);
}

bool HandleArea::isFarOutside(const QPointF& pixel) const {
    return !QRectF(rect())
                .adjusted(-awayPixels, -awayPixels, awayPixels, awayPixels)
                .contains(pixel);
}

void HandleArea::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    endNudging();
    before_ = handles_;
    std::optional<std::size_t> pressed = handleNear(event->position());
    const bool isNew = !pressed;
    if (isNew) {
        pressed = insert(handleAt(event->position()));
    }
    if (!pressed) {
        return;
    }
    base_ = handles_;
    dragged_ = pressed;
    setChosen(pressed);
    Q_EMIT interactionBegan();
    if (isNew) {
        Q_EMIT changed();
    }
}

void HandleArea::mouseMoveEvent(QMouseEvent* event) {
    if (!dragged_) {
        setCursor(handleNear(event->position()) ? Qt::SizeAllCursor : Qt::CrossCursor);
        return;
    }
    handles_ = base_;
    if (isFarOutside(event->position()) && base_.size() > limits_.min) {
        handles_.erase(handles_.begin() + static_cast<std::ptrdiff_t>(*dragged_));
        setChosen(std::nullopt);
    } else {
        moveThroughOthers(dragged(base_[*dragged_], event->position()));
    }
    Q_EMIT changed();
}

void HandleArea::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && std::exchange(dragged_, std::nullopt)) {
        Q_EMIT interactionEnded();
    }
}

void HandleArea::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto pressed = handleNear(event->position())) {
        setChosen(pressed);
        Q_EMIT activated();
    }
}

void HandleArea::cancelDrag() {
    dragged_.reset();
    handles_ = before_;
    setChosen(std::nullopt);
    Q_EMIT changed();
    Q_EMIT interactionEnded();
}

void HandleArea::chooseNext(int steps) {
    if (handles_.empty()) {
        return;
    }
    const int last = static_cast<int>(handles_.size()) - 1;
    const int from = chosen_ ? static_cast<int>(*chosen_) + steps : steps > 0 ? 0 : last;
    setChosen(static_cast<std::size_t>(std::clamp(from, 0, last)));
}

void HandleArea::nudge(double right, double up) {
    if (!chosen_) {
        chooseNext(1);
        return;
    }
    if (!nudging_.isActive()) {
        Q_EMIT interactionBegan();
    }
    nudging_.start();
    replaceChosen(stepped(handles_[*chosen_], right, up));
}

void HandleArea::endNudging() {
    if (nudging_.isActive()) {
        nudging_.stop();
        Q_EMIT interactionEnded();
    }
}

void HandleArea::replaceChosen(const Handle& wanted) {
    if (chosen_) {
        Handle& chosen = handles_[*chosen_];
        const double x = roomFor(wanted.x, *chosen_).value_or(chosen.x);
        chosen = wanted;
        chosen.x = x;
        update();
        Q_EMIT changed();
    }
}

void HandleArea::removeChosen() {
    if (!chosen_ || handles_.size() <= limits_.min) {
        return;
    }
    endNudging();
    handles_.erase(handles_.begin() + static_cast<std::ptrdiff_t>(*chosen_));
    setChosen(std::min(*chosen_, handles_.size() - 1));
    Q_EMIT changed();
}

void HandleArea::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? fineKeyStep : keyStep;
    switch (event->key()) {
    case Qt::Key_Escape:
        return dragged_ ? cancelDrag() : event->ignore(); // closes the popup
    case Qt::Key_Left:
        return nudge(-step, 0.0);
    case Qt::Key_Right:
        return nudge(step, 0.0);
    case Qt::Key_Up:
        return nudge(0.0, step);
    case Qt::Key_Down:
        return nudge(0.0, -step);
    case Qt::Key_PageUp:
        return chooseNext(-1);
    case Qt::Key_PageDown:
        return chooseNext(1);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return removeChosen();
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (chosen_) {
            Q_EMIT activated();
        }
        return;
    default:
        event->ignore();
    }
}

void HandleArea::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    endNudging();
    if (std::exchange(dragged_, std::nullopt)) {
        Q_EMIT interactionEnded();
    }
}

} // namespace patina
