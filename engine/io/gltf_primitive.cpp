// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_primitive.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include <fmt/format.h>

#include "io/gltf_accessor.h"
#include "io/gltf_draco.h"

namespace patina {
namespace {

/// Reads an optional attribute; a missing one leaves the target empty.
template <class Vector>
Result<void> readAttribute(const tinygltf::Model& model, GltfViews& views,
                           const tinygltf::Primitive& primitive, const char* name,
                           std::vector<Vector>& target) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) {
        return {};
    }
    const auto floats = readFloats(model, views, found->second, std::size_t(Vector::length()));
    if (!floats) {
        return tl::unexpected(floats.error());
    }
    target.resize(floats->size() / std::size_t(Vector::length()));
    std::memcpy(static_cast<void*>(target.data()), floats->data(), floats->size() * sizeof(float));
    return {};
}

/// Reads colours of three or four numbers, which are in linear light (glTF 2.0, section 3.7.2.1).
Result<void> readColors(const tinygltf::Model& model, GltfViews& views,
                        const tinygltf::Primitive& primitive, std::vector<glm::vec4>& colors) {
    constexpr const char* name = "COLOR_0";
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end() || componentsOf(model, found->second) != 3) {
        return readAttribute(model, views, primitive, name, colors);
    }
    std::vector<glm::vec3> opaque;
    return readAttribute(model, views, primitive, name, opaque).map([&] {
        colors = withAlpha(opaque);
    });
}

template <class Vector>
bool hasLength(const std::vector<Vector>& attribute, std::size_t length) {
    return attribute.empty() || attribute.size() == length;
}

Result<RawMesh> readAttributes(const tinygltf::Model& model, GltfViews& views,
                               const tinygltf::Primitive& primitive) {
    RawMesh mesh;
    auto read = readAttribute(model, views, primitive, "POSITION", mesh.positions)
                    .and_then([&] {
                        return readAttribute(model, views, primitive, "NORMAL", mesh.normals);
                    })
                    .and_then([&] {
                        return readAttribute(model, views, primitive, "TANGENT", mesh.tangents);
                    })
                    .and_then([&] {
                        return readAttribute(model, views, primitive, "TEXCOORD_0", mesh.uvs);
                    })
                    .and_then([&] { return readColors(model, views, primitive, mesh.colors); });
    if (!read) {
        return tl::unexpected(read.error());
    }
    const std::size_t count = mesh.positions.size();
    if (!hasLength(mesh.normals, count) || !hasLength(mesh.tangents, count) ||
        !hasLength(mesh.uvs, count) || !hasLength(mesh.colors, count)) {
        return failure("the attributes of a mesh differ in length");
    }
    return mesh;
}

Result<std::vector<std::uint32_t>> cornersOf(const tinygltf::Model& model, GltfViews& views,
                                             const tinygltf::Primitive& primitive,
                                             std::size_t vertices) {
    if (primitive.indices < 0) {
        std::vector<std::uint32_t> all(vertices);
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }
    auto indices = readIndices(model, views, primitive.indices);
    if (indices && std::ranges::any_of(*indices, [&](auto index) { return index >= vertices; })) {
        return failure(fmt::format("a mesh has an index beyond its {} vertices", vertices));
    }
    return indices;
}

/// Returns the triangles that corners make in a mode (glTF 2.0, section 3.7.2.1).
std::vector<std::uint32_t> trianglesFrom(const std::vector<std::uint32_t>& corners, int mode) {
    std::vector<std::uint32_t> triangles;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        triangles = corners;
        triangles.resize(corners.size() / 3 * 3);
        return triangles;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
        } else {
            const std::size_t odd = i % 2;
            triangles.insert(triangles.end(),
                             {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
        }
    }
    return triangles;
}

bool drawsTriangles(int mode) {
    return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

} // namespace

Result<RawMesh> readPrimitive(const tinygltf::Model& model, GltfViews& views,
                              const tinygltf::Primitive& primitive) {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (!drawsTriangles(mode)) {
        RawMesh nothing;
        nothing.pointsAndLines = 1;
        return nothing;
    }
    if (isDraco(primitive)) {
        return readDraco(model, views, primitive);
    }
    auto mesh = readAttributes(model, views, primitive);
    if (!mesh) {
        return mesh;
    }
    const auto corners = cornersOf(model, views, primitive, mesh->positions.size());
    if (!corners) {
        return tl::unexpected(corners.error());
    }
    mesh->indices = trianglesFrom(*corners, mode);
    return mesh;
}

} // namespace patina
