// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "core/mesh.h"

namespace patina {

/// Defines how a mesh lies in a shared block: a 64-byte header, the vertices, the indices.
class MeshBlock {
  public:
    /// Returns the block's size in bytes; 0 for an impossible mesh (empty, not of triangles, or too
    /// large for 32-bit indices).
    static std::size_t sizeFor(std::size_t vertexCount, std::size_t indexCount);

    /// Writes the header into a fresh block of sizeFor(...) bytes and returns where the caller must
    /// write the vertices and indices.
    static MeshBlock format(std::span<std::byte> block, std::size_t vertexCount,
                            std::size_t indexCount);

    /// Returns a view of a mesh that another process wrote. Fails when the sizes do not match the
    /// block's length, when a number of a vertex is not finite, or when an index is beyond the
    /// vertices. The bounds are computed here, not taken from the block.
    static Result<MeshView> checked(std::span<const std::byte> block);

    std::span<Vertex> vertices;
    std::span<std::uint32_t> indices;
};

} // namespace patina
