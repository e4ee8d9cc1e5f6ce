// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

class ChoiceBox;

/// Offers a list of choices, each with its own explanation as a tooltip.
class EnumEditor : public ParameterEditor {
    Q_OBJECT

  public:
    EnumEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    ChoiceBox* box_;
};

} // namespace patina
