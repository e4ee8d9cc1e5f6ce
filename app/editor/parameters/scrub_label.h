// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace patina {

/// Lets the label of a number be dragged sideways to change it. It tells how far it was dragged;
/// the number's editor decides what that means. It is a plain label until it is made draggable.
class ScrubLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ScrubLabel(const QString& text, QWidget* parent = nullptr);

    void setDraggable();

  Q_SIGNALS:
    void scrubBegan();
    /// `pixels` count from the last one.
    void scrubbed(double pixels, Qt::KeyboardModifiers modifiers);
    void scrubCancelled(); ///< Esc was pressed; scrubEnded() follows
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
    double pressed_ = 0.0; ///< pixels on the screen
    double last_ = 0.0;
};

} // namespace patina
