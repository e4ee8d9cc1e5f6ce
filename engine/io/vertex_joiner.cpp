// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vertex_joiner.h"

#include <algorithm>

#include <meshoptimizer.h>

namespace patina {
namespace {

/// -0 and 0 are one place but two bit patterns; adding zero makes them one.
template <class T>
void dropNegativeZeros(std::vector<T>& values) {
    for (T& value : values) {
        value += 0.0f;
    }
}

template <class T>
void addStream(std::vector<meshopt_Stream>& streams, const std::vector<T>& values) {
    if (!values.empty()) {
        streams.push_back({values.data(), sizeof(T), sizeof(T)});
    }
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
    std::vector<meshopt_Stream> streams;
    addStream(streams, mesh.positions);
    addStream(streams, mesh.normals);
    addStream(streams, mesh.tangents);
    addStream(streams, mesh.uvs);
    std::vector<std::uint32_t> target(mesh.positions.size());
    const std::size_t count = meshopt_generateVertexRemapMulti(
        target.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.size(),
        streams.data(), streams.size());
    meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(),
                             target.data());
    remap(mesh.positions, target, count);
    remap(mesh.normals, target, count);
    remap(mesh.tangents, target, count);
    remap(mesh.uvs, target, count);
}

Places placesOf(const RawMesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    if (mesh.normals.empty() && mesh.tangents.empty() && mesh.uvs.empty()) {
        return {{}, vertices}; // joined by position already
    }
    Places places;
    places.ofVertex.resize(vertices);
    places.count = meshopt_generateVertexRemap(places.ofVertex.data(), nullptr, vertices,
                                               mesh.positions.data(), vertices, sizeof(glm::vec3));
    return places;
}

} // namespace patina
