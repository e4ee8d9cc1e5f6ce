// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QPoint>
#include <QTimer>

#include "viewport/frame_loop.h"

namespace patina {

/// Reads the numbers of the pixel under the pointer while a view shows the numerical check. Moves
/// that follow each other quickly are read once.
class PixelProber : public QObject {
    Q_OBJECT

  public:
    /// Both references outlive it; `widget` shows the frames.
    PixelProber(FrameLoop& frames, const QWidget& widget);

    /// Sets where the pointer is, in the widget's coordinates; it is empty while the pointer is not
    /// over the view.
    void setPointer(std::optional<QPoint> pointer);

  Q_SIGNALS:
    /// Sends the numbers under the pointer; `numbers` is empty where there is no surface.
    void probed(const std::optional<patina::PixelProbe>& numbers);

  private:
    void probeSoon();
    void probe();

    FrameLoop& frames_;
    const QWidget& widget_;
    std::optional<QPoint> pointer_;
    QTimer timer_;
};

} // namespace patina
