// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

class NumberEdit;

/// A slider and a box for a whole number.
class IntEditor : public ParameterEditor {
    Q_OBJECT

  public:
    IntEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    NumberEdit* number_;
};

} // namespace patina
