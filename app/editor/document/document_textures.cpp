// SPDX-License-Identifier: GPL-3.0-or-later
// Images on the values of a material.
#include "document/commands/texture_command.h"
#include "document/document.h"
#include "viewport/texture_library.h"

namespace patina {

std::string textureKey(const BlockPath& path, std::string_view parameterId) {
    const BlockKind* kind = findKind(path.kind);
    return kind && kind->isPart ? path.kind + '.' + std::string(parameterId)
                                : std::string(parameterId);
}

bool takesTextures(const BlockPath& path) {
    return path.owner == BlockOwner::Material && !path.isAt(settings::accuracy);
}

void Document::setTextureLibrary(TextureLibrary* library) {
    textureLibrary_ = library;
    connect(library, &TextureLibrary::loaded, this, &Document::imagesArrived);
    connect(library, &TextureLibrary::failed, this, &Document::imagesArrived);
}

const TextureUse* Document::texture(const BlockPath& path, std::string_view parameterId) const {
    const Material* held =
        takesTextures(path) ? materialAt(state_, path.index, path.side) : nullptr;
    if (!held) {
        return nullptr;
    }
    const auto found = held->textures.find(textureKey(path, parameterId));
    return found == held->textures.end() ? nullptr : &found->second;
}

void Document::setTexture(const BlockPath& path, std::string_view parameterId,
                          const std::optional<TextureUse>& use) {
    const Block* described = block(path);
    const Parameter* parameter = described ? described->parameter(parameterId) : nullptr;
    const TextureUse* held = texture(path, parameterId);
    const bool isSame = held ? use && *use == *held : !use;
    if (!parameter || !takesTextures(path) || isSame ||
        !materialAt(state_, path.index, path.side)) {
        return;
    }
    if (textureLibrary_ && use && (!held || use->file != held->file)) {
        textureLibrary_->forgetFailures(); // it may be there by now
    }
    const QString name = QString::fromStdString(parameter->label);
    const QString label = !use    ? tr("Remove image of %1").arg(name)
                          : !held ? tr("Image on %1").arg(name)
                                  : tr("Change image of %1").arg(name);
    undoStack_.push(
        new TextureCommand(*this, {path, std::string(parameterId)}, use, label));
}

} // namespace patina
