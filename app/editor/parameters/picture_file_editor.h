// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

class QToolButton;

namespace patina {

/// Shows the name of a picture's file, or of measurements', on a button, which opens a dialog to
/// choose another one. It takes files that are dropped on it.
class PictureFileEditor : public ParameterEditor {
    Q_OBJECT

  public:
    PictureFileEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void choose();
    void take(const QString& file);

    QString file_;
    QToolButton* button_;
};

} // namespace patina
