// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace patina {

/// Tells whether a glTF extension is read.
inline bool isReadExtension(std::string_view name) {
    constexpr std::array<std::string_view, 11> read{
        "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization",
        "KHR_materials_ior",          "KHR_materials_specular",  "KHR_materials_emissive_strength",
        "KHR_materials_transmission", "KHR_materials_volume",    "KHR_materials_dispersion",
        "KHR_materials_anisotropy",   "KHR_texture_transform"};
    return std::ranges::find(read, name) != read.end();
}

/// Tells whether a glTF extension says how materials or their textures are.
inline bool isOfMaterials(std::string_view extension) {
    constexpr std::array<std::string_view, 4> prefixes{"KHR_materials_", "KHR_texture_",
                                                       "EXT_texture_", "MSFT_texture_"};
    return std::ranges::any_of(
        prefixes, [extension](std::string_view each) { return extension.starts_with(each); });
}

} // namespace patina
