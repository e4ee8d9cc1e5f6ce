// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "catalog/descriptor.h"
#include "catalog/json_reader.h"

namespace patina {

/// What every scene, camera, object, light and material has, whatever blocks are chosen. Each set
/// of such values has a descriptor without a shader (settings/<word>.json) and goes by a word, as
/// blocks go by their kind.
namespace settings {
inline constexpr std::string_view scene = "scene";
inline constexpr std::string_view camera = "camera";
inline constexpr std::string_view object = "object";
inline constexpr std::string_view light = "light";
inline constexpr std::string_view material = "material";
inline constexpr std::string_view accuracy = "accuracy"; ///< the choices of a material's blocks
} // namespace settings

/// Returns the descriptors, sorted by their words.
std::span<const Descriptor> settingsDescriptors();

/// Returns what describes the settings of a word; null where nothing does.
const Block* settingsBlock(std::string_view word);

/// Stores the value of a parameter, and tells what is held then.
using StoreSetting = std::function<Value(std::string_view id, const Value& value)>;

/// Reads settings from an object of a file. An id names the keys on the way to its value: "a.b" is
/// the key "b" of the object "a". What is out of its range is brought into it, with a note. Returns
/// what was not known of the objects inside, by their keys.
nlohmann::json readSettings(JsonReader& reader, const Block& block, Errors& notes,
                            const StoreSetting& store);

/// Writes them into an object of a file, beside what it has already.
void writeSettings(nlohmann::json& json, const Block& block,
                   const std::function<std::optional<Value>(std::string_view id)>& held);

} // namespace patina
