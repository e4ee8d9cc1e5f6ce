// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLabel;
class QOpenGLWidget;

namespace patina {

/// How a view says that its picture is on its way.
class DrawingNote {
  public:
    /// The view owns it.
    explicit DrawingNote(QOpenGLWidget& widget);

    /// Over the picture that is there, or over nothing: then its context is current.
    void show(bool hasPicture);
    void hide();

  private:
    QOpenGLWidget& widget_;
    QLabel* label_;
};

} // namespace patina
