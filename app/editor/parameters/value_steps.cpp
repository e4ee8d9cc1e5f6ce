// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/value_steps.h"

#include <cmath>

#include <QKeyEvent>
#include <QWheelEvent>

namespace patina {

namespace {

constexpr double fine = 0.1;
constexpr double pageSteps = 10.0;
constexpr double wheelNotch = 120; // QWheelEvent::angleDelta of one notch

} // namespace

std::optional<double> stepsOf(const QKeyEvent& key) {
    switch (key.key()) {
    case Qt::Key_Up:
        return fineness(key.modifiers());
    case Qt::Key_Down:
        return -fineness(key.modifiers());
    case Qt::Key_PageUp:
        return pageSteps;
    case Qt::Key_PageDown:
        return -pageSteps;
    default:
        return std::nullopt;
    }
}

double WheelSteps::take(const QWheelEvent& event) {
    rest_ += event.angleDelta().y() / wheelNotch;
    const double notches = std::trunc(rest_);
    rest_ -= notches;
    return notches * fineness(event.modifiers());
}

double fineness(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ShiftModifier) ? fine : 1.0;
}

} // namespace patina
