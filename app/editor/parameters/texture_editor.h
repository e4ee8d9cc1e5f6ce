// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

/// Takes no room: the row's line for its image is all there is to edit.
class TextureEditor : public ParameterEditor {
    Q_OBJECT

  public:
    TextureEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override { return this; }
};

} // namespace patina
