// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>

#include "catalog/json_reader.h"
#include "material/reading_rights.h"
#include "material/texture_use.h"

namespace patina {

/// Holds the images of a preset, by key, and what stood among them that is none.
struct TextureReading {
    std::map<std::string, TextureUse, std::less<>> uses;
    nlohmann::json unknown = nlohmann::json::object();
};

/// Reads the object "textures" of a preset; paths start at the references' folder, or stay as they
/// are where there is none. What loses nothing is noted, the rest are errors of the reader's list.
TextureReading readTextures(JsonReader& preset, References& references, Errors& notes);

/// Returns the JSON of one image, every setting written.
nlohmann::json toJson(const TextureUse& use, std::string_view key,
                      const std::filesystem::path& folder);

} // namespace patina
