// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/editor_factory.h"

#include "parameters/bool_editor.h"
#include "parameters/color_editor.h"
#include "parameters/enum_editor.h"
#include "parameters/number_editor.h"
#include "parameters/picture_file_editor.h"
#include "parameters/texture_editor.h"
#include "parameters/vector_editor.h"

namespace patina {

ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent) {
    switch (parameter.type) {
    case ParameterType::Bool:
        return new BoolEditor(parameter, parent);
    case ParameterType::Color:
        return new ColorEditor(parameter, parent);
    case ParameterType::Vec2:
    case ParameterType::Vec3:
        return new VectorEditor(parameter, parent);
    case ParameterType::Enum:
        return new EnumEditor(parameter, parent);
    case ParameterType::Texture:
        return parameter.textureChannels.empty()
                   ? static_cast<ParameterEditor*>(new PictureFileEditor(parameter, parent))
                   : new TextureEditor(parameter, parent);
    default:
        return new NumberEditor(parameter, parent);
    }
}

} // namespace patina
