// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace patina {

/// Turns the mouse and the keys over a view into wishes. It moves nothing itself.
///
/// Left drag orbits, middle drag or Shift+left pans, right drag and the wheel dolly; Alt with the
/// left, middle and right button orbits, pans and dollies as in Maya; Ctrl+left turns the object;
/// left with the L key held turns the key light; Shift+right turns the environment; a double click
/// asks for a pivot.
class CameraNavigation : public QObject {
    Q_OBJECT

  public:
    /// Tells what a drag does, from the press to the release.
    enum class Drag { None, Orbit, Pan, Dolly, TurnObject, TurnLight, TurnEnvironment };

    explicit CameraNavigation(QObject* parent = nullptr);

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    bool keyPress(const QKeyEvent& event);   ///< true when the key means something here
    bool keyRelease(const QKeyEvent& event); ///< the same
    void focusLost();

  Q_SIGNALS:
    void orbitWished(double yaw, double pitch); ///< degrees
    void panWished(QPointF pixels);
    void dollyWished(double factor);
    void objectTurnWished(double yaw, double pitch); ///< degrees
    void lightTurnWished(double yaw, double pitch);  ///< degrees
    void environmentTurnWished(double yaw);          ///< degrees
    void dragFinished();
    void pivotWished(QPointF place);
    void frameWished();
    void resetWished();
    void directionWished(double yaw, double pitch); ///< degrees, absolute

  private:
    void drag(const QPointF& pixels);

    Drag drag_ = Drag::None;
    Qt::MouseButton button_ = Qt::NoButton;
    QPointF last_;
    bool lightKey_ = false;
};

} // namespace patina
