// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/texture_command.h"

namespace patina {
namespace {

std::optional<TextureUse> held(const Document& document, const ParameterTarget& target) {
    const TextureUse* use = document.texture(target.path, target.parameterId);
    return use ? std::optional(*use) : std::nullopt;
}

} // namespace

TextureCommand::TextureCommand(Document& document, const ParameterTarget& target,
                               const std::optional<TextureUse>& after, const QString& label)
    : ChangeCommand(document, label, target, held(document, target), after) {}

void TextureCommand::apply(const std::optional<TextureUse>& use) {
    const BlockPath& path = target().path;
    Material* material = materialAt(state(), path.index, path.side);
    if (!material) {
        return;
    }
    const std::string key = textureKey(path, target().parameterId);
    if (use) {
        material->textures.insert_or_assign(key, *use);
    } else {
        material->textures.erase(key);
    }
    document().announce({DocumentChange::Texture, path, target().parameterId});
}

} // namespace patina
