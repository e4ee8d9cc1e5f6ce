// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_navigation.h"

#include <cmath>
#include <utility>

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

/// One press of an arrow key orbits by these degrees or pans by these pixels.
constexpr double degreesPerKey = 5.0;
constexpr double pixelsPerKey = 30.0;

/// Qt counts a wheel's turn in eighths of a degree, 15 degrees to the notch.
constexpr double eighthsPerNotch = 120.0;

/// Converts the turn of a wheel where a trackpad reports no pixels.
constexpr double eighthsPerPixel = 8.0;

/// Pixels; a pointer that moves less between press and release has clicked
constexpr double clickSlack = 3.0;

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

Drag dragAsInBlender(Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ControlModifier)) {
        return Drag::Dolly;
    }
    return modifiers.testFlag(Qt::ShiftModifier) ? Drag::Pan : Drag::Orbit;
}

/// Returns what the left button drags without Alt. In schemes where it does not move the camera a
/// press only picks.
Drag dragWithLeft(Qt::KeyboardModifiers modifiers, MouseScheme scheme) {
    if (modifiers.testFlag(Qt::ControlModifier)) {
        return Drag::TurnObject;
    }
    if (scheme == MouseScheme::Maya || scheme == MouseScheme::Blender) {
        return Drag::Pick;
    }
    return modifiers.testFlag(Qt::ShiftModifier) ? Drag::Pan : Drag::Orbit;
}

Drag dragFor(const QMouseEvent& event, bool lightKey, MouseScheme scheme) {
    const bool alt = event.modifiers().testFlag(Qt::AltModifier);
    if (!alt && event.button() == Qt::LeftButton) {
        return lightKey ? Drag::TurnLight : dragWithLeft(event.modifiers(), scheme);
    }
    if (event.button() == Qt::RightButton && event.modifiers() == Qt::ShiftModifier) {
        return Drag::TurnEnvironment;
    }
    if (scheme == MouseScheme::Blender && event.button() == Qt::MiddleButton) {
        return dragAsInBlender(event.modifiers());
    }
    const bool isIdle = scheme == MouseScheme::Maya && !alt;
    return isIdle ? Drag::None : dragWithAlt(event.button());
}

} // namespace

CameraNavigation::CameraNavigation(QObject* parent) : QObject(parent) {}

void CameraNavigation::press(const QMouseEvent& event) {
    if (drag_ != Drag::None) {
        return;
    }
    drag_ = dragFor(event, lightKey_, habits_.scheme);
    button_ = event.button();
    last_ = event.position();
    isClick_ = true;
    if (isDragging()) {
        Q_EMIT dragBegan();
    }
}

void CameraNavigation::move(const QMouseEvent& event) {
    const QPointF pixels = event.position() - last_;
    if (drag_ == Drag::None || (isClick_ && pixels.manhattanLength() < clickSlack)) {
        return;
    }
    isClick_ = false;
    last_ = event.position();
    if (!pixels.isNull()) {
        drag(pixels);
    }
}

void CameraNavigation::release(const QMouseEvent& event) {
    if (drag_ == Drag::None || event.button() != button_) {
        return;
    }
    const Drag drag = std::exchange(drag_, Drag::None);
    Q_EMIT dragFinished();
    if (isClick_ && event.button() == Qt::LeftButton &&
        (drag == Drag::Orbit || drag == Drag::Pick || drag == Drag::TurnObject)) {
        Q_EMIT pickWished(event.position(), drag == Drag::TurnObject);
    } else if (isClick_ && drag == Drag::TurnLight) {
        Q_EMIT lightPickWished(event.position(), event.modifiers().testFlag(Qt::ShiftModifier));
    }
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
    const double factor = std::exp(-dollyPerNotch * notches);
    const bool isZoom = event.modifiers().testFlag(Qt::ControlModifier);
    if (habits_.scheme == MouseScheme::Trackpad && !isZoom) {
        const QPointF pixels(event.pixelDelta());
        scroll(pixels.isNull() ? QPointF(event.angleDelta()) / eighthsPerPixel : pixels,
               event.modifiers());
    } else if (notches != 0.0 && isZoom) {
        Q_EMIT zoomWished(factor, event.position());
    } else if (notches != 0.0 && habits_.wheelZooms) {
        Q_EMIT dollyWished(factor);
    }
}

/// Pans or orbits by a scroll with two fingers on a trackpad.
void CameraNavigation::scroll(const QPointF& pixels, Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        Q_EMIT panWished(pixels);
    } else if (!pixels.isNull()) {
        Q_EMIT orbitWished(-pixels.x() * degreesPerPixel, pixels.y() * degreesPerPixel);
    }
}

bool CameraNavigation::keyPress(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape && isDragging()) {
        drag_ = Drag::None;
        Q_EMIT dragCancelled();
        return true;
    }
    if (event.key() == Qt::Key_Escape) {
        Q_EMIT pickCancelled();
    }
    if (event.key() == Qt::Key_L && (event.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier) {
        lightKey_ = true;
        return true;
    }
    const bool isKeypad = event.modifiers().testFlag(Qt::KeypadModifier);
    const bool isDigit = event.key() >= Qt::Key_1 && event.key() <= Qt::Key_9;
    return (isKeypad && keypadPress(event)) || (isDigit && !isKeypad && digitPress(event)) ||
           moveKeyPress(event);
}

/// Asks for the views from the front, the right and above; with Ctrl for those from the opposite
/// sides.
bool CameraNavigation::keypadPress(const QKeyEvent& event) {
    const bool isBehind = event.modifiers().testFlag(Qt::ControlModifier);
    switch (event.key()) {
    case Qt::Key_1:
        Q_EMIT directionWished(isBehind ? 180.0 : 0.0, 0.0);
        return true;
    case Qt::Key_3:
        Q_EMIT directionWished(isBehind ? -90.0 : 90.0, 0.0);
        return true;
    case Qt::Key_7:
        Q_EMIT directionWished(0.0, isBehind ? -90.0 : 90.0);
        return true;
    case Qt::Key_5:
        Q_EMIT lensWished();
        return true;
    case Qt::Key_4:
        Q_EMIT orbitWished(-degreesPerKey, 0.0);
        return true;
    case Qt::Key_6:
        Q_EMIT orbitWished(degreesPerKey, 0.0);
        return true;
    case Qt::Key_8:
        Q_EMIT orbitWished(0.0, degreesPerKey);
        return true;
    case Qt::Key_2:
        Q_EMIT orbitWished(0.0, -degreesPerKey);
        return true;
    case Qt::Key_0:
        Q_EMIT resetWished();
        return true;
    default:
        return false;
    }
}

bool CameraNavigation::digitPress(const QKeyEvent& event) {
    const Qt::KeyboardModifiers modifiers = event.modifiers();
    if (modifiers != Qt::NoModifier && modifiers != Qt::ControlModifier) {
        return false;
    }
    Q_EMIT bookmarkWished(event.key() - Qt::Key_0, modifiers == Qt::ControlModifier);
    return true;
}

bool CameraNavigation::moveKeyPress(const QKeyEvent& event) {
    const bool isPan = event.modifiers().testFlag(Qt::ShiftModifier);
    const auto move = [&](double x, double y) {
        if (isPan) {
            Q_EMIT panWished(QPointF(-x, y) * pixelsPerKey);
        } else {
            Q_EMIT orbitWished(x * degreesPerKey, y * degreesPerKey);
        }
        return true;
    };
    switch (event.key()) {
    case Qt::Key_Left:
        return move(-1.0, 0.0);
    case Qt::Key_Right:
        return move(1.0, 0.0);
    case Qt::Key_Up:
        return move(0.0, 1.0);
    case Qt::Key_Down:
        return move(0.0, -1.0);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        Q_EMIT dollyWished(std::exp(-dollyPerNotch));
        return true;
    case Qt::Key_Minus:
        Q_EMIT dollyWished(std::exp(dollyPerNotch));
        return true;
    case Qt::Key_F:
        if (event.modifiers() == Qt::NoModifier) {
            Q_EMIT frameWished();
            return true;
        }
        return false;
    case Qt::Key_Home:
        Q_EMIT resetWished();
        return true;
    default:
        return false;
    }
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
    case Drag::Pick:
    case Drag::None:
        break;
    }
}

} // namespace patina
