// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "parameters/parameter_editor.h"

namespace patina {

class SliderWithBox;

/// Shows a slider and a box for each component of a vec2 or vec3, one below the other.
class VectorEditor : public ParameterEditor {
    Q_OBJECT

  public:
    VectorEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    Value withComponent(int component, double number) const;

    Value value_;
    std::vector<SliderWithBox*> numbers_;
};

} // namespace patina
