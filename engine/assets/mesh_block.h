// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "core/mesh.h"

namespace patina {

/// Tells how a mesh lies in a shared block: a 64-byte header, the vertices, the indices.
class MeshBlock {
  public:
    /// Returns the block's size in bytes; 0 when such a mesh cannot be (too large for 32-bit
    /// indices).
    static std::size_t sizeFor(std::size_t vertexCount, std::size_t indexCount);

    /// Writes the header into a fresh block of sizeFor(...) bytes; the rest is the caller's.
    static MeshBlock format(std::span<std::byte> block, std::size_t vertexCount,
                            std::size_t indexCount);

    /// Returns a mesh another process wrote. Checked before use: the sizes against the block's
    /// length, every number of a vertex finite, every index within the vertices. The bounds are
    /// computed here, not believed.
    static Result<MeshView> checked(std::span<const std::byte> block);

    std::span<Vertex> vertices;
    std::span<std::uint32_t> indices;
};

} // namespace patina
