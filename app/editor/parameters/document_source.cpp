// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/document_source.h"

#include "resources/texture_library.h"

namespace patina {

std::optional<TextureUse> DocumentSource::texture(std::string_view parameterId) const {
    const TextureUse* use = document_.texture(path_, parameterId);
    return use ? std::optional(*use) : std::nullopt;
}

TexturePreview DocumentSource::preview(const TextureUse& use) const {
    const TextureLibrary* library = document_.textureLibrary();
    if (!library) {
        return {};
    }
    return {library->preview(use.file), library->problem(use), library->hasAlpha(use.file)};
}

} // namespace patina
