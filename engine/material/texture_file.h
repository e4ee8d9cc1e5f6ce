// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>

#include "catalog/json_reader.h"
#include "material/reading_rights.h"
#include "material/texture_use.h"

namespace patina {

/// Holds the images of a preset by key, and the entries among them that name no file.
struct TextureReading {
    std::map<std::string, TextureUse, std::less<>> uses;
    nlohmann::json unknown = nlohmann::json::object();
};

/// Reads the object "textures" of a preset. Paths start at the references' folder, or are unchanged
/// where there is none. Problems that lose nothing go to `notes`, others to the reader's errors.
TextureReading readTextures(JsonReader& preset, References& references, Errors& notes);

/// Returns the JSON of one image with every setting; its path is relative to `folder`.
nlohmann::json toJson(const TextureUse& use, std::string_view key,
                      const std::filesystem::path& folder);

} // namespace patina
