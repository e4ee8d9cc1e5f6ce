// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLabel;
class QWidget;

namespace patina {

class ViewSurface;

/// Says in a view that its picture is still being drawn.
class DrawingNote {
  public:
    /// `widget` owns the label and outlives this; `surface` shows its picture.
    DrawingNote(QWidget& widget, ViewSurface& surface);

    /// Shows the note over the last picture, or over an empty view where there is none.
    void show();
    void hide();

  private:
    QLabel* label_;
};

} // namespace patina
