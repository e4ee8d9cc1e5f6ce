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

/// Reads <kind>/<id>.json: the kind is the folder's name, the shader the .glsl file beside it.
/// The schema is "descriptor". All mistakes of the file are reported at once.
Checked<Descriptor> readDescriptor(const std::filesystem::path& path, const JsonSchema& schema);

/// Returns what the text of a descriptor without a shader declares; its file's stem is the id.
Descriptor settingsDescriptor(const LocatedJson& document);

/// A block under the field names of descriptor files, every field written, and its kind.
nlohmann::json toJson(const Block& block);

} // namespace patina
