// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/mesh.h"
#include "core/mesh_material.h"

namespace patina {

/// Refers to the triangles of one part of a mesh, and says what their material is.
struct MeshPartView {
    MeshMaterial material;
    MeshView view;
};

/// Defines how a mesh lies in a shared block: a 64-byte header, the vertices of all parts, the
/// colours of those that have some, their indices, which count from the first vertex of their part,
/// the sizes of the parts, and a text about their materials.
class MeshBlock {
  public:
    /// Returns the block's size in bytes; 0 for an impossible mesh (empty, not of triangles, or too
    /// large for 32-bit indices).
    static std::size_t sizeFor(std::span<const MeshPart> parts);

    /// Writes all but vertices and indices into a fresh block of sizeFor(...) bytes, and returns
    /// where the caller must write those.
    static MeshBlock format(std::span<std::byte> block, std::span<const MeshPart> parts);

    /// Returns views of the parts of a mesh that another process wrote; at least one. Fails when
    /// the sizes do not match the block's length, when a number of a vertex is not finite, when an
    /// index is beyond the vertices of its part, or when the text is not what format() writes. The
    /// bounds are computed here, not taken from the block.
    static Result<std::vector<MeshPartView>> checked(std::span<const std::byte> block);

    std::span<Vertex> vertices;
    std::span<std::uint32_t> indices;
    std::span<VertexColor> colors;
};

} // namespace patina
