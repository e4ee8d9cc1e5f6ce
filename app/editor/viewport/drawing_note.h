// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLabel;
class QOpenGLWidget;

namespace patina {

/// Says in a view that its picture is still being drawn.
class DrawingNote {
  public:
    /// `widget` owns the label and outlives this.
    explicit DrawingNote(QOpenGLWidget& widget);

    /// Shows the note over the last picture, or over a cleared view where there is none; then the
    /// widget's context has to be current.
    void show(bool hasPicture);
    void hide();

  private:
    QOpenGLWidget& widget_;
    QLabel* label_;
};

} // namespace patina
