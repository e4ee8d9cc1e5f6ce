// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/mesh_material.h"
#include "io/left_out.h"

namespace patina {

/// Holds triangles as a file has them: vertices may be repeated, attributes may be missing. An
/// attribute is empty, or has one value per position; a zero normal or tangent is unknown.
struct RawMesh {
    static constexpr std::uint32_t noMaterial = 0xffffffff;

    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> uvs;
    /// Are in linear light, with alpha; a vertex whose colour nobody knows is white.
    std::vector<glm::vec4> colors;
    std::vector<std::uint32_t> indices; ///< has three per triangle, each below positions.size()
    std::vector<MeshMaterial> materials;
    /// Has the index of each triangle's material, `noMaterial` where it has none; it is empty, or
    /// shorter than the triangles, where all those that are left have none.
    std::vector<std::uint32_t> materialOf;
    std::size_t pointsAndLines = 0;  ///< counts points and lines, which are not read
    LeftOut leftOut;                 ///< is what else the file has
    std::shared_ptr<void> leftovers; ///< keeps the reader's data alive; freeing it may take a while

    /// Moves the vertices from `first` on, and the triangles from `firstIndex` on, by an affine
    /// transform. A mirroring one reverses the winding.
    void transform(const glm::dmat4& matrix, std::size_t first, std::size_t firstIndex);

    /// Gives the triangles from `firstIndex` on a material.
    void setMaterial(std::size_t firstIndex, std::uint32_t material);

    /// Makes linear light of colours that are encoded as for a screen (sRGB).
    void decodeColors();

    /// Extends attributes that only some parts of the file have to the length of the positions.
    void padAttributes();
};

/// Returns colours that have no alpha as opaque ones.
std::vector<glm::vec4> withAlpha(const std::vector<glm::vec3>& colors);

} // namespace patina
