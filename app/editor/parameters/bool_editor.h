// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

class QCheckBox;

namespace patina {

/// Edits a bool in a check box.
class BoolEditor : public ParameterEditor {
    Q_OBJECT

  public:
    BoolEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    QCheckBox* box_;
};

} // namespace patina
