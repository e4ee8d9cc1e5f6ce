// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

class NumberEdit;

/// A slider and a box for a float or an angle in degrees.
class FloatEditor : public ParameterEditor {
    Q_OBJECT

  public:
    FloatEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    NumberEdit* number_;
};

} // namespace patina
