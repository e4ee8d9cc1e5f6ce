// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

class SliderWithBox;

/// Shows a slider and a box for a float, a whole number or an angle in degrees.
class NumberEditor : public ParameterEditor {
    Q_OBJECT

  public:
    NumberEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;
    void scrubWith(ScrubLabel& label) override;

  private:
    Value valueOf(double number) const;

    SliderWithBox* number_;
};

} // namespace patina
