// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace patina {

/// Represents a label that can be dragged sideways to change the number it names. It tells the way
/// that was dragged; what that means is its number's business. A plain label until it is made
/// draggable.
class ScrubLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ScrubLabel(const QString& text, QWidget* parent = nullptr);

    void setDraggable();

  Q_SIGNALS:
    void scrubBegan();
    void scrubbed(double pixels, Qt::KeyboardModifiers modifiers); ///< since the last one
    void scrubCancelled(); ///< by Esc; the end follows
    void scrubEnded();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    enum class Drag { None, Pressed, Scrubbing };

    void begin();
    void end();

    bool isDraggable_ = false;
    Drag drag_ = Drag::None;
    double pressed_ = 0.0; ///< where on the screen
    double last_ = 0.0;
};

} // namespace patina
