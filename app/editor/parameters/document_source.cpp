// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/document_source.h"

#include "document/value_locks.h"
#include "resources/texture_library.h"

namespace patina {

std::optional<TextureUse> DocumentSource::texture(std::string_view parameterId) const {
    const TextureUse* use = document_.texture(path_, parameterId);
    return use ? std::optional(*use) : std::nullopt;
}

void DocumentSource::setTexture(std::string_view parameterId,
                                const std::optional<TextureUse>& use) {
    const TextureUse* held = document_.texture(path_, parameterId);
    if (use && (!held || use->file != held->file)) {
        textures_.forgetFailures(); // it may be there by now
    }
    document_.setTexture(path_, parameterId, use);
}

TexturePreview DocumentSource::preview(const TextureUse& use) const {
    return {textures_.preview(use.file), textures_.problem(use), textures_.hasAlpha(use.file)};
}

bool DocumentSource::isLocked(std::string_view parameterId) const {
    return patina::isLocked(document_.state(), path_, parameterId);
}

void DocumentSource::setLocked(const std::vector<std::string>& parameterIds, bool locked) {
    patina::setLocked(document_, path_, parameterIds, locked);
}

} // namespace patina
