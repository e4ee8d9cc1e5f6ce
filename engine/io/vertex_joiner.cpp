// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vertex_joiner.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <meshoptimizer.h>

namespace patina {
namespace {

/// Adds zero to every value, so that -0 and 0, which are one place, have one bit pattern.
template <class T>
void dropNegativeZeros(std::vector<T>& values) {
    for (T& value : values) {
        value += 0.0f;
    }
}

using Streams = std::vector<meshopt_Stream>;

template <class T>
void addStream(Streams& streams, const std::vector<T>& values) {
    if (!values.empty()) {
        streams.push_back({values.data(), sizeof(T), sizeof(T)});
    }
}

Streams streamsOf(const RawMesh& mesh) {
    Streams streams;
    addStream(streams, mesh.positions);
    addStream(streams, mesh.normals);
    addStream(streams, mesh.tangents);
    addStream(streams, mesh.uvs);
    addStream(streams, mesh.colors);
    return streams;
}

/// Finds equal vertices among those seen last. Files list each corner of each face, and neighbours
/// follow each other: most vertices equal one of the few thousand seen last. Finding those in a
/// table that stays in the processor's cache, before meshoptimizer looks at the rest in a table
/// that does not, halves the time of joining.
class RecentVertices {
  public:
    explicit RecentVertices(Streams streams) : streams_(std::move(streams)) { recent_.fill(none); }

    /// Returns an earlier vertex that agrees in every attribute, or the vertex itself.
    std::uint32_t same(std::uint32_t vertex) {
        std::uint32_t& slot = recent_[hash(vertex) >> (32 - slotBits)];
        if (slot == none || !agree(slot, vertex)) {
            slot = vertex;
        }
        return slot;
    }

  private:
    static constexpr std::uint32_t none = 0xffffffff;
    static constexpr int slotBits = 14;

    static const unsigned char* at(const meshopt_Stream& stream, std::uint32_t vertex) {
        return static_cast<const unsigned char*>(stream.data) + vertex * stream.stride;
    }

    /// Hashes the position's three words by multiplication (Knuth, The Art of Computer Programming
    /// 3, section 6.4).
    std::uint32_t hash(std::uint32_t vertex) const {
        std::uint32_t words[3];
        std::memcpy(words, at(streams_.front(), vertex), sizeof words);
        return (words[0] * 73856093u ^ words[1] * 19349663u ^ words[2] * 83492791u) * 2654435769u;
    }

    bool agree(std::uint32_t a, std::uint32_t b) const {
        return std::ranges::all_of(streams_, [&](const meshopt_Stream& stream) {
            return std::memcmp(at(stream, a), at(stream, b), stream.size) == 0;
        });
    }

    Streams streams_;
    std::array<std::uint32_t, std::size_t(1) << slotBits> recent_;
};

template <class T>
void gather(std::vector<T>& values, const std::vector<std::uint32_t>& kept) {
    if (values.empty()) {
        return;
    }
    std::vector<T> gathered;
    gathered.reserve(kept.size());
    for (const std::uint32_t vertex : kept) {
        gathered.push_back(values[vertex]);
    }
    values = std::move(gathered);
}

/// Drops vertices that no triangle uses and most of those that equal another.
void joinRecent(RawMesh& mesh) {
    constexpr std::uint32_t unknown = 0xffffffff;
    RecentVertices recent(streamsOf(mesh));
    std::vector<std::uint32_t> target(mesh.positions.size(), unknown);
    std::vector<std::uint32_t> kept;
    kept.reserve(mesh.positions.size() / 4);
    for (std::uint32_t& index : mesh.indices) {
        const std::uint32_t vertex = recent.same(index);
        if (target[vertex] == unknown) {
            target[vertex] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(vertex);
        }
        index = target[vertex];
    }
    gather(mesh.positions, kept);
    gather(mesh.normals, kept);
    gather(mesh.tangents, kept);
    gather(mesh.uvs, kept);
    gather(mesh.colors, kept);
}

template <class T>
void remap(std::vector<T>& values, const std::vector<std::uint32_t>& target, std::size_t count) {
    if (values.empty()) {
        return;
    }
    std::vector<T> joined(count);
    meshopt_remapVertexBuffer(joined.data(), values.data(), values.size(), sizeof(T),
                              target.data());
    values = std::move(joined);
}

} // namespace

void joinVertices(RawMesh& mesh) {
    dropNegativeZeros(mesh.positions);
    dropNegativeZeros(mesh.normals);
    dropNegativeZeros(mesh.tangents);
    dropNegativeZeros(mesh.uvs);
    dropNegativeZeros(mesh.colors);
    joinRecent(mesh);
    const Streams streams = streamsOf(mesh);
    std::vector<std::uint32_t> target(mesh.positions.size());
    const std::size_t count =
        meshopt_generateVertexRemapMulti(target.data(), mesh.indices.data(), mesh.indices.size(),
                                         mesh.positions.size(), streams.data(), streams.size());
    meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(),
                             target.data());
    remap(mesh.positions, target, count);
    remap(mesh.normals, target, count);
    remap(mesh.tangents, target, count);
    remap(mesh.uvs, target, count);
    remap(mesh.colors, target, count);
}

Places placesOf(const RawMesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    if (mesh.normals.empty() && mesh.tangents.empty() && mesh.uvs.empty() && mesh.colors.empty()) {
        return {{}, vertices}; // joined by position already
    }
    Places places;
    places.ofVertex.resize(vertices);
    places.count = meshopt_generateVertexRemap(places.ofVertex.data(), nullptr, vertices,
                                               mesh.positions.data(), vertices, sizeof(glm::vec3));
    return places;
}

} // namespace patina
