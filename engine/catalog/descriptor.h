// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "catalog/block.h"
#include "catalog/json_schema.h"

namespace patina {

/// Holds a block as its descriptor file declares it, with the file's text for later messages.
struct Descriptor {
    Block block;
    LocatedJson document;
};

/// Reads <kind>/<id>.json: the kind is the folder's name, the shader the .glsl file beside it. The
/// schema is "descriptor". All mistakes of the file are reported at once.
Checked<Descriptor> readDescriptor(const std::filesystem::path& path, const JsonSchema& schema);

/// Returns what the text of a descriptor without a shader declares; the kind is "settings".
Descriptor settingsDescriptor(const LocatedJson& document);

/// Returns a block and its kind under the field names of descriptor files; fields are written even
/// where they have their defaults.
nlohmann::json toJson(const Block& block);

} // namespace patina
