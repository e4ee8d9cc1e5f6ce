// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_navigation.h"

#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace patina {
namespace {

/// A drag across 450 pixels turns by 180 degrees.
constexpr double degreesPerPixel = 0.4;

/// A drag of 100 pixels changes the distance by a factor of about 1.65.
constexpr double dollyPerPixel = 0.005;

/// One notch of an ordinary wheel changes the distance by about 13 percent.
constexpr double dollyPerNotch = 0.12;

/// Qt counts a wheel's turn in eighths of a degree, 15 degrees to the notch.
constexpr double eighthsPerNotch = 120.0;

using Drag = CameraNavigation::Drag;

Drag dragWithAlt(Qt::MouseButton button) {
    switch (button) {
    case Qt::LeftButton:
        return Drag::Orbit;
    case Qt::MiddleButton:
        return Drag::Pan;
    case Qt::RightButton:
        return Drag::Dolly;
    default:
        return Drag::None;
    }
}

Drag dragWithLeft(Qt::KeyboardModifiers modifiers, bool lightKey) {
    if (lightKey) {
        return Drag::TurnLight;
    }
    if (modifiers.testFlag(Qt::ControlModifier)) {
        return Drag::TurnObject;
    }
    return modifiers.testFlag(Qt::ShiftModifier) ? Drag::Pan : Drag::Orbit;
}

Drag dragFor(const QMouseEvent& event, bool lightKey) {
    const bool alt = event.modifiers().testFlag(Qt::AltModifier);
    if (!alt && event.button() == Qt::LeftButton) {
        return dragWithLeft(event.modifiers(), lightKey);
    }
    if (event.button() == Qt::RightButton && event.modifiers() == Qt::ShiftModifier) {
        return Drag::TurnEnvironment;
    }
    return dragWithAlt(event.button());
}

} // namespace

CameraNavigation::CameraNavigation(QObject* parent) : QObject(parent) {}

void CameraNavigation::press(const QMouseEvent& event) {
    if (drag_ != Drag::None) {
        return;
    }
    drag_ = dragFor(event, lightKey_);
    button_ = event.button();
    last_ = event.position();
}

void CameraNavigation::move(const QMouseEvent& event) {
    const QPointF pixels = event.position() - last_;
    last_ = event.position();
    if (!pixels.isNull()) {
        drag(pixels);
    }
}

void CameraNavigation::release(const QMouseEvent& event) {
    if (drag_ == Drag::None || event.button() != button_) {
        return;
    }
    drag_ = Drag::None;
    Q_EMIT dragFinished();
}

void CameraNavigation::doubleClick(const QMouseEvent& event) {
    if (event.button() == Qt::LeftButton && event.modifiers() == Qt::NoModifier) {
        Q_EMIT pivotWished(event.position());
        return;
    }
    press(event);
}

void CameraNavigation::wheel(const QWheelEvent& event) {
    const double notches = event.angleDelta().y() / eighthsPerNotch;
    if (notches != 0.0) {
        Q_EMIT dollyWished(std::exp(-dollyPerNotch * notches));
    }
}

bool CameraNavigation::keyPress(const QKeyEvent& event) {
    const bool keypad = event.modifiers().testFlag(Qt::KeypadModifier);
    if (event.key() == Qt::Key_L) {
        lightKey_ = true;
    } else if (event.key() == Qt::Key_F && event.modifiers() == Qt::NoModifier) {
        Q_EMIT frameWished();
    } else if (event.key() == Qt::Key_Home && !keypad) {
        Q_EMIT resetWished();
    } else if (keypad && event.key() == Qt::Key_1) {
        Q_EMIT directionWished(0.0, 0.0);
    } else if (keypad && event.key() == Qt::Key_3) {
        Q_EMIT directionWished(90.0, 0.0);
    } else if (keypad && event.key() == Qt::Key_7) {
        Q_EMIT directionWished(0.0, 90.0);
    } else {
        return false;
    }
    return true;
}

bool CameraNavigation::keyRelease(const QKeyEvent& event) {
    if (event.key() != Qt::Key_L) {
        return false;
    }
    lightKey_ = event.isAutoRepeat() && lightKey_;
    return true;
}

void CameraNavigation::focusLost() {
    lightKey_ = false;
}

void CameraNavigation::drag(const QPointF& pixels) {
    const QPointF turn = pixels * degreesPerPixel;
    switch (drag_) {
    case Drag::Orbit:
        Q_EMIT orbitWished(-turn.x(), turn.y());
        break;
    case Drag::Pan:
        Q_EMIT panWished(pixels);
        break;
    case Drag::Dolly:
        Q_EMIT dollyWished(std::exp(dollyPerPixel * (pixels.y() - pixels.x())));
        break;
    case Drag::TurnObject:
        Q_EMIT objectTurnWished(turn.x(), turn.y());
        break;
    case Drag::TurnLight:
        Q_EMIT lightTurnWished(turn.x(), turn.y());
        break;
    case Drag::TurnEnvironment:
        Q_EMIT environmentTurnWished(turn.x());
        break;
    case Drag::None:
        break;
    }
}

} // namespace patina
