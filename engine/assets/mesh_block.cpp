// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/mesh_block.h"

#include <cstring>
#include <limits>

namespace patina {
namespace {

constexpr std::uint32_t meshMagic = 0x48534d50; // "PMSH"
constexpr std::uint32_t meshVersion = 1;

struct MeshHeader {
    std::uint32_t magic = meshMagic;
    std::uint32_t version = meshVersion;
    std::uint64_t vertexCount = 0;
    std::uint64_t indexCount = 0;
    std::uint64_t reserved[5] = {};
};
static_assert(sizeof(MeshHeader) == 64);
static_assert(sizeof(Vertex) == 48);

/// Returns true when no float has all exponent bits set (infinity or not a number).
bool allFinite(std::span<const Vertex> vertices) {
    constexpr std::uint32_t exponent = 0x7f800000;
    bool bad = false;
    for (const Vertex& vertex : vertices) {
        std::uint32_t words[sizeof(Vertex) / 4];
        std::memcpy(words, &vertex, sizeof vertex);
        for (const std::uint32_t word : words) {
            bad |= (word & exponent) == exponent;
        }
    }
    return !bad;
}

bool allBelow(std::span<const std::uint32_t> indices, std::uint64_t limit) {
    std::uint32_t highest = 0;
    for (const std::uint32_t index : indices) {
        highest = index > highest ? index : highest;
    }
    return highest < limit;
}

} // namespace

std::size_t MeshBlock::sizeFor(std::size_t vertexCount, std::size_t indexCount) {
    constexpr std::size_t limit = std::numeric_limits<std::uint32_t>::max();
    if (vertexCount == 0 || vertexCount > limit || indexCount == 0 || indexCount > limit ||
        indexCount % 3 != 0) {
        return 0;
    }
    return sizeof(MeshHeader) + vertexCount * sizeof(Vertex) + indexCount * sizeof(std::uint32_t);
}

MeshBlock MeshBlock::format(std::span<std::byte> block, std::size_t vertexCount,
                            std::size_t indexCount) {
    MeshHeader header;
    header.vertexCount = vertexCount;
    header.indexCount = indexCount;
    std::memcpy(block.data(), &header, sizeof header);
    std::byte* const vertices = block.data() + sizeof header;
    std::byte* const indices = vertices + vertexCount * sizeof(Vertex);
    return {{reinterpret_cast<Vertex*>(vertices), vertexCount},
            {reinterpret_cast<std::uint32_t*>(indices), indexCount}};
}

Result<MeshView> MeshBlock::checked(std::span<const std::byte> block) {
    MeshHeader header;
    if (block.size() < sizeof header) {
        return failure("the mesh block is shorter than its header");
    }
    std::memcpy(&header, block.data(), sizeof header);
    if (header.magic != meshMagic || header.version != meshVersion) {
        return failure("the mesh block does not start as one");
    }
    if (block.size() != sizeFor(header.vertexCount, header.indexCount)) {
        return failure("the mesh block does not have the size it claims");
    }
    const std::byte* const first = block.data() + sizeof header;
    const std::span vertices(reinterpret_cast<const Vertex*>(first), header.vertexCount);
    const std::span indices(
        reinterpret_cast<const std::uint32_t*>(vertices.data() + vertices.size()),
        header.indexCount);
    if (!allFinite(vertices)) {
        return failure("the mesh block has a number that is not finite");
    }
    if (!allBelow(indices, header.vertexCount)) {
        return failure("the mesh block has an index beyond its vertices");
    }
    return MeshView{vertices, indices, boundsOf(vertices)};
}

} // namespace patina
