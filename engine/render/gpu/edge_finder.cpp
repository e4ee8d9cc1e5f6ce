// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/edge_finder.h"

#include <algorithm>
#include <bit>

namespace patina {
namespace {

/// Returns the size of a hash table for `items`: a power of two, of which at least a third stays
/// free.
std::size_t slotsFor(std::size_t items) {
    return std::bit_ceil(items + items / 2 + 1);
}

/// Is the last step of SplitMix64 (Steele, Lea and Flood 2014).
std::size_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return static_cast<std::size_t>(x ^ (x >> 31));
}

/// Returns the bits of the number; 0 and -0 give the same ones.
std::uint64_t bitsOf(float x) {
    return std::bit_cast<std::uint32_t>(x + 0.0f);
}

std::size_t hashOf(const glm::vec3& place) {
    return mixed(bitsOf(place.x) << 32 ^ bitsOf(place.y) ^ mixed(bitsOf(place.z)));
}

std::size_t hashOf(std::uint32_t from, std::uint32_t to) {
    return mixed(std::uint64_t(from) << 32 | to);
}

} // namespace

EdgeFinder::EdgeFinder(const MeshView& mesh)
    : joined_(mesh.vertices.size()), vertexTable_(slotsFor(mesh.vertices.size())),
      edgeTable_(slotsFor(mesh.indices.size())), triangles_(mesh.indices.size() / 3) {
    edges_.reserve(mesh.indices.size() / 2);
    faces_.reserve(mesh.indices.size() / 2);
}

void EdgeFinder::proceed(const MeshView& mesh, std::size_t items) {
    const std::size_t lastVertex = std::min(vertex_ + items, mesh.vertices.size());
    for (; vertex_ < lastVertex; ++vertex_, --items) {
        joinVertex(mesh, static_cast<std::uint32_t>(vertex_));
    }
    if (vertex_ < mesh.vertices.size()) {
        return;
    }
    const std::size_t lastTriangle = std::min(triangle_ + items, triangles_);
    for (; triangle_ < lastTriangle; ++triangle_) {
        addTriangle(mesh, triangle_);
    }
}

void EdgeFinder::joinVertex(const MeshView& mesh, std::uint32_t vertex) {
    const glm::vec3& place = mesh.vertices[vertex].position;
    const std::size_t last = vertexTable_.size() - 1;
    std::size_t slot = hashOf(place) & last;
    while (vertexTable_[slot] != 0 && mesh.vertices[vertexTable_[slot] - 1].position != place) {
        slot = (slot + 1) & last;
    }
    if (vertexTable_[slot] == 0) {
        vertexTable_[slot] = vertex + 1;
    }
    joined_[vertex] = vertexTable_[slot] - 1;
}

void EdgeFinder::addTriangle(const MeshView& mesh, std::size_t triangle) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = joined_[mesh.indices[3 * triangle + i]];
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
        return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        addFace(corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]);
    }
}

void EdgeFinder::addFace(std::uint32_t from, std::uint32_t to, std::uint32_t beside) {
    const std::uint32_t first = std::min(from, to);
    const std::uint32_t second = std::max(from, to);
    const std::size_t last = edgeTable_.size() - 1;
    std::size_t slot = hashOf(first, second) & last;
    const auto isOther = [&](const MeshEdge& edge) {
        return edge[1] != first || edge[2] != second;
    };
    while (edgeTable_[slot] != 0 && isOther(edges_[edgeTable_[slot] - 1])) {
        slot = (slot + 1) & last;
    }
    if (edgeTable_[slot] == 0) {
        edges_.push_back({beside, first, second, beside});
        faces_.push_back(1);
        edgeTable_[slot] = static_cast<std::uint32_t>(edges_.size());
        return;
    }
    const std::size_t number = edgeTable_[slot] - 1;
    MeshEdge& edge = edges_[number];
    edge[3] = faces_[number] == 1 ? beside : edge[0];
    faces_[number] = static_cast<std::uint8_t>(std::min(faces_[number] + 1, 3));
}

} // namespace patina
