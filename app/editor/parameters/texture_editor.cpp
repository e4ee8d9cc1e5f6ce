// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/texture_editor.h"

#include "parameters/editor_factory.h"
#include "parameters/picture_file_editor.h"

namespace patina {

TextureEditor::TextureEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent) {
    setFixedSize(0, 0);
    setAccessibleName(name());
}

void TextureEditor::present(const Value&) {}

/// Makes an editor without parts for a value that is an image, whose row has a line for it, and a
/// file chooser for any other file.
ParameterEditor* makeTextureEditor(const Parameter& parameter, QWidget* parent) {
    return parameter.textureChannels.empty()
               ? static_cast<ParameterEditor*>(new PictureFileEditor(parameter, parent))
               : new TextureEditor(parameter, parent);
}

} // namespace patina
