// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace patina {

/// Is the name of vertex colours in place of an image's path: those of the mesh that is shown drive
/// a value as an image does.
inline constexpr std::string_view vertexColorsName = "builtin:vertex-colors";

inline bool isVertexColors(std::string_view image) {
    return image == vertexColorsName;
}

/// Says what a mesh file says of one of its materials, in the same words for every format.
struct MeshMaterial {
    std::string name; ///< is unlike those of the file's other materials, and never empty
    /// Is "matte", "rough-matte", "phong", "blinn-phong", "dielectric", "metal", one of these two
    /// with a grain, "grained-dielectric" or "grained-metal", or "metallic-roughness", which is
    /// both, point by point; empty where the file says nothing of how it looks.
    std::string look;
    /// Holds "diffuse", "specular", "emissive" and "f0" in linear light, "shininess", "alpha" (the
    /// width of the highlight), "metalness", "anisotropy" (1 less the ratio of its widths along and
    /// across the grain, over 0.9), "grain" (degrees from the tangent), "roughness" (that of a
    /// matte surface) and "opacity"; a number is in all three. With a grain "alpha" is the
    /// geometric mean of both widths.
    std::map<std::string, glm::dvec3> values;
    /// Holds full paths of images, data URIs of those inside the file, or vertexColorsName, by the
    /// same words, by "normal" and by "height".
    std::map<std::string, std::string> images;
    /// Holds the preset that the material was exported from, as JSON, whose images are those below;
    /// empty where the file has none or says other values since.
    std::string preset;
    /// Holds full paths of the images of the preset, or data URIs, by their keys.
    std::map<std::string, std::string> presetImages;
    /// Holds what only other programs know of it, as JSON, to be written back; mostly empty.
    std::string foreign;

    bool isMetal() const { return look.ends_with("metal"); }
    bool isDielectric() const { return look.ends_with("dielectric"); }
    bool hasMetalness() const { return look == "metallic-roughness"; }
    bool hasGrain() const { return look.starts_with("grained-"); }

    friend bool operator==(const MeshMaterial&, const MeshMaterial&) = default;
};

/// Describes the triangles of a mesh that have one material.
struct MeshPart {
    MeshMaterial material;
    std::size_t vertices = 0;
    std::size_t indices = 0;
    bool hasColors = false; ///< says that some vertex is not white

    friend bool operator==(const MeshPart&, const MeshPart&) = default;
};

} // namespace patina
