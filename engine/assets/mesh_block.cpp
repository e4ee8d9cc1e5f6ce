// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/mesh_block.h"

#include <cstring>
#include <limits>
#include <string>

#include "assets/material_text.h"

namespace patina {
namespace {

constexpr std::uint32_t meshMagic = 0x48534d50; // "PMSH"
constexpr std::uint32_t meshVersion = 3;
constexpr std::size_t maxParts = 4096;

struct MeshHeader {
    std::uint32_t magic = meshMagic;
    std::uint32_t version = meshVersion;
    std::uint64_t vertexCount = 0;
    std::uint64_t indexCount = 0;
    std::uint64_t partCount = 0;
    std::uint64_t textBytes = 0; ///< has no padding: it is the end of the block
    std::uint64_t colorCount = 0;
    std::uint64_t reserved[2] = {};
};
static_assert(sizeof(MeshHeader) == 64);

struct PartSize {
    std::uint32_t vertices = 0;
    std::uint32_t indices = 0;
    std::uint32_t colors = 0; ///< is 0, or as many as vertices
};
static_assert(sizeof(Vertex) == 48);
static_assert(sizeof(VertexColor) == 8);

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

std::size_t colorsOf(const MeshPart& part) {
    return part.hasColors ? part.vertices : 0;
}

MeshHeader headerFor(std::span<const MeshPart> parts) {
    MeshHeader header;
    for (const MeshPart& part : parts) {
        header.vertexCount += part.vertices;
        header.indexCount += part.indices;
        header.colorCount += colorsOf(part);
    }
    header.partCount = parts.size();
    header.textBytes = materialText(parts).size();
    return header;
}

/// Returns the size of the block with this header; 0 where there can be none.
std::size_t sizeOf(const MeshHeader& header) {
    constexpr std::size_t limit = std::numeric_limits<std::uint32_t>::max();
    if (header.vertexCount == 0 || header.vertexCount > limit || header.indexCount == 0 ||
        header.indexCount > limit || header.indexCount % 3 != 0 || header.partCount == 0 ||
        header.partCount > maxParts || header.textBytes > limit ||
        header.colorCount > header.vertexCount) {
        return 0;
    }
    return sizeof(MeshHeader) + header.vertexCount * sizeof(Vertex) +
           header.colorCount * sizeof(VertexColor) + header.indexCount * sizeof(std::uint32_t) +
           header.partCount * sizeof(PartSize) + header.textBytes;
}

/// Holds what is left of a mesh whose parts are taken one after the other.
struct Rest {
    std::span<const Vertex> vertices;
    std::span<const std::uint32_t> indices;
    std::span<const VertexColor> colors;

    bool isEmpty() const { return vertices.empty() && indices.empty() && colors.empty(); }
};

/// Takes a part's triangles from the front.
Result<MeshView> takePart(Rest& rest, const PartSize& size) {
    if (size.vertices > rest.vertices.size() || size.indices > rest.indices.size() ||
        size.indices == 0 || size.indices % 3 != 0 || size.colors > rest.colors.size() ||
        (size.colors != 0 && size.colors != size.vertices)) {
        return failure("the mesh block has a part of an impossible size");
    }
    const std::span own = rest.vertices.first(size.vertices);
    const std::span corners = rest.indices.first(size.indices);
    const std::span colors = rest.colors.first(size.colors);
    rest.vertices = rest.vertices.subspan(size.vertices);
    rest.indices = rest.indices.subspan(size.indices);
    rest.colors = rest.colors.subspan(size.colors);
    if (!allBelow(corners, own.size())) {
        return failure("the mesh block has an index beyond its vertices");
    }
    return MeshView{own, corners, boundsOf(own), {}, colors};
}

} // namespace

std::size_t MeshBlock::sizeFor(std::span<const MeshPart> parts) {
    return sizeOf(headerFor(parts));
}

MeshBlock MeshBlock::format(std::span<std::byte> block, std::span<const MeshPart> parts) {
    const MeshHeader header = headerFor(parts);
    const std::string text = materialText(parts);
    std::memcpy(block.data(), &header, sizeof header);
    std::byte* const vertices = block.data() + sizeof header;
    std::byte* const colors = vertices + header.vertexCount * sizeof(Vertex);
    std::byte* const indices = colors + header.colorCount * sizeof(VertexColor);
    std::byte* rest = indices + header.indexCount * sizeof(std::uint32_t);
    for (const MeshPart& part : parts) {
        const PartSize size{static_cast<std::uint32_t>(part.vertices),
                            static_cast<std::uint32_t>(part.indices),
                            static_cast<std::uint32_t>(colorsOf(part))};
        std::memcpy(rest, &size, sizeof size);
        rest += sizeof size;
    }
    std::memcpy(rest, text.data(), text.size());
    return {{reinterpret_cast<Vertex*>(vertices), header.vertexCount},
            {reinterpret_cast<std::uint32_t*>(indices), header.indexCount},
            {reinterpret_cast<VertexColor*>(colors), header.colorCount}};
}

Result<std::vector<MeshPartView>> MeshBlock::checked(std::span<const std::byte> block) {
    MeshHeader header;
    if (block.size() < sizeof header) {
        return failure("the mesh block is shorter than its header");
    }
    std::memcpy(&header, block.data(), sizeof header);
    if (header.magic != meshMagic || header.version != meshVersion) {
        return failure("the mesh block does not start as one");
    }
    if (sizeOf(header) == 0 || block.size() != sizeOf(header)) {
        return failure("the mesh block does not have the size it claims");
    }
    const std::byte* const first = block.data() + sizeof header;
    const std::span vertices(reinterpret_cast<const Vertex*>(first), header.vertexCount);
    const std::span colors(reinterpret_cast<const VertexColor*>(vertices.data() + vertices.size()),
                           header.colorCount);
    const std::span indices(reinterpret_cast<const std::uint32_t*>(colors.data() + colors.size()),
                            header.indexCount);
    const std::span sizes(reinterpret_cast<const PartSize*>(indices.data() + indices.size()),
                          header.partCount);
    const std::string_view text(reinterpret_cast<const char*>(sizes.data() + sizes.size()),
                                header.textBytes);
    if (!allFinite(vertices)) {
        return failure("the mesh block has a number that is not finite");
    }
    auto materials = materialsIn(text, header.partCount);
    if (!materials) {
        return failure("the mesh block does not say what its materials are");
    }
    Rest rest{vertices, indices, colors};
    std::vector<MeshPartView> parts;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto view = takePart(rest, sizes[i]);
        if (!view) {
            return tl::unexpected(view.error());
        }
        parts.push_back({std::move((*materials)[i]), *view});
    }
    if (!rest.isEmpty()) {
        return failure("the mesh block has more than its parts");
    }
    return parts;
}

} // namespace patina
