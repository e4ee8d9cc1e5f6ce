// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>

#include "session/mouse_scheme.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace patina {

/// Turns input of the mouse and the keys over a view into requests, which are its signals. It moves
/// nothing itself.
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
    bool keyPress(const QKeyEvent& event);   ///< returns true where the key was used
    bool keyRelease(const QKeyEvent& event); ///< returns true where the key was used
    void focusLost();

    bool isDragging() const { return drag_ != Drag::None; }
    bool isLightKeyHeld() const { return lightKey_; }

  Q_SIGNALS:
    void dragBegan();
    void dragCancelled(); ///< asks to restore what was there when the drag began; sent by Esc
    void pickCancelled(); ///< says that no click is to be waited for; sent by Esc
    void orbitWished(double yaw, double pitch); ///< degrees
    void panWished(QPointF pixels);
    void dollyWished(double factor);
    void zoomWished(double factor, QPointF place); ///< asks that what is at `place` stays there
    void lensWished(); ///< toggles between the orthographic lens and the one before it
    /// Asks to store the view under the digit, or else to go to it.
    void bookmarkWished(int digit, bool isKept);
    void objectTurnWished(double yaw, double pitch); ///< degrees
    void lightTurnWished(double yaw, double pitch);  ///< degrees
    void environmentTurnWished(double yaw);          ///< degrees
    void dragFinished();
    void pivotWished(QPointF place);
    /// Reports a click; `adds` to the selection with Ctrl.
    void pickWished(QPointF place, bool adds);
    /// Asks, on a click with L held, for the light's highlight at a place, or for a shadow there
    /// (with Shift).
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
    bool isClick_ = false; ///< the pointer has not moved since the press
    bool lightKey_ = false;
    MouseHabits habits_;
};

} // namespace patina
