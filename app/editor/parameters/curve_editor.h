// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/curve.h"
#include "parameters/parameter_editor.h"

namespace patina {

class CurvePopup;
class PreviewButton;

/// Shows the curve as a small picture, which opens a popup that edits it.
class CurveEditor : public ParameterEditor {
    Q_OBJECT

  public:
    CurveEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    void openPopup();

    CurvePoints points_;
    PreviewButton* preview_;
    CurvePopup* popup_ = nullptr; ///< is made when it is first opened
};

} // namespace patina
