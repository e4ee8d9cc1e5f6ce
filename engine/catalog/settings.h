// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "catalog/descriptor.h"
#include "catalog/json_reader.h"

namespace patina {

/// Names what every scene, camera, object, light and material has, whatever blocks are chosen. Each
/// set of such values has a descriptor without a shader (settings/<word>.json), and its word is
/// used like the kind of a block.
namespace settings {
inline constexpr std::string_view scene = "scene";
inline constexpr std::string_view camera = "camera";
inline constexpr std::string_view object = "object";
inline constexpr std::string_view light = "light";
inline constexpr std::string_view material = "material";
/// Names the choices of a material's blocks, which have no such descriptor.
inline constexpr std::string_view accuracy = "accuracy";
} // namespace settings

/// Returns the descriptors, sorted by their words.
std::span<const Descriptor> settingsDescriptors();

/// Returns the block that describes the settings of a word; null where there is none.
const Block* settingsBlock(std::string_view word);

/// Stores the value of a parameter, and returns the value that is held then.
using StoreSetting = std::function<Value(std::string_view id, const Value& value)>;

/// Reads settings from an object of a file. An id names the keys that lead to its value: "a.b" is
/// the key "b" of the object "a". A value out of its range is brought into it, with a note. Returns
/// the unknown members of the objects inside, by their keys.
nlohmann::json readSettings(JsonReader& reader, const Block& block, Errors& notes,
                            const StoreSetting& store);

/// Writes the values that `held` returns into an object of a file, beside what it has already.
void writeSettings(nlohmann::json& json, const Block& block,
                   const std::function<std::optional<Value>(std::string_view id)>& held);

} // namespace patina
