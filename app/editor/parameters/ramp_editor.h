// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/ramp.h"
#include "parameters/parameter_editor.h"

namespace patina {

class PreviewButton;
class RampPopup;

/// Shows the ramp as a strip of its colours, which opens a popup that edits it.
class RampEditor : public ParameterEditor {
    Q_OBJECT

  public:
    RampEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    void openPopup();

    Ramp ramp_;
    PreviewButton* preview_;
    RampPopup* popup_ = nullptr; ///< is made when it is first opened
};

} // namespace patina
