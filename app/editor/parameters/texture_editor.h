// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

/// Says that images cannot be chosen here; what a file says about them is kept.
class TextureEditor : public ParameterEditor {
    Q_OBJECT

  public:
    TextureEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override { return this; }
};

} // namespace patina
