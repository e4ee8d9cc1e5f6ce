// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>

#include "session/mouse_scheme.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace patina {

/// Turns the mouse and the keys over a view into wishes. It moves nothing itself.
///
/// Left drag orbits, middle drag or Shift+left pans, right drag and the wheel dolly; Alt with the
/// left, middle and right button orbits, pans and dollies as in Maya; Ctrl+left turns the object;
/// left with the L key held turns the key light; Shift+right turns the environment; a double click
/// asks for a pivot. A left press that goes nowhere is a click, which picks; with Ctrl it adds to
/// what is picked. Esc takes a drag back. Arrows, plus and minus and the keypad move the camera,
/// digits go to bookmarks.
class CameraNavigation : public QObject {
    Q_OBJECT

  public:
    /// Tells what a drag does, from the press to the release.
    enum class Drag { None, Pick, Orbit, Pan, Dolly, TurnObject, TurnLight, TurnEnvironment };

    explicit CameraNavigation(QObject* parent = nullptr);

    void setHabits(const MouseHabits& habits) { habits_ = habits; }

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    bool keyPress(const QKeyEvent& event);   ///< true when the key means something here
    bool keyRelease(const QKeyEvent& event); ///< the same
    void focusLost();

    bool isDragging() const { return drag_ != Drag::None; }
    bool isLightKeyHeld() const { return lightKey_; }

  Q_SIGNALS:
    void dragBegan();
    void dragCancelled();                       ///< Esc: all is to be as it was when the drag began
    void orbitWished(double yaw, double pitch); ///< degrees
    void panWished(QPointF pixels);
    void dollyWished(double factor);
    void zoomWished(double factor, QPointF place);   ///< what is there stays there
    void lensWished();                               ///< the orthographic one, or the one before
    void bookmarkWished(int digit, bool isKept);     ///< to keep the view under it, or to go there
    void objectTurnWished(double yaw, double pitch); ///< degrees
    void lightTurnWished(double yaw, double pitch);  ///< degrees
    void environmentTurnWished(double yaw);          ///< degrees
    void dragFinished();
    void pivotWished(QPointF place);
    void pickWished(QPointF place, bool adds); ///< a click; with Ctrl: to what is selected
    /// A click with L held: the light's highlight, or with Shift a shadow, is wanted there.
    void lightPickWished(QPointF place, bool isShadow);
    void frameWished();
    void resetWished();
    void directionWished(double yaw, double pitch); ///< degrees, absolute

  private:
    void drag(const QPointF& pixels);
    void scroll(const QPointF& pixels, Qt::KeyboardModifiers modifiers);
    bool keypadPress(const QKeyEvent& event);
    bool digitPress(const QKeyEvent& event);
    bool moveKeyPress(const QKeyEvent& event);

    Drag drag_ = Drag::None;
    Qt::MouseButton button_ = Qt::NoButton;
    QPointF last_;
    bool isClick_ = false; ///< the pointer has not gone anywhere since the press
    bool lightKey_ = false;
    MouseHabits habits_;
};

} // namespace patina
