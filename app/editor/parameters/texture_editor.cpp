// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/texture_editor.h"

namespace patina {

TextureEditor::TextureEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent) {
    setFixedSize(0, 0);
    setAccessibleName(name());
}

void TextureEditor::present(const Value&) {}

} // namespace patina
