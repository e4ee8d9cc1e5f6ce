// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_draco.h"

#include <algorithm>
#include <array>
#include <string>

#include <draco/compression/decode.h>
#include <draco/core/decoder_buffer.h>
#include <draco/mesh/mesh.h>
#include <glm/gtc/type_ptr.hpp>

namespace patina {
namespace {

constexpr const char* dracoExtension = "KHR_draco_mesh_compression";

/// Returns Draco's own identifier of a glTF attribute; -1 when the primitive has no such attribute.
int identifierOf(const tinygltf::Value& extension, const std::string& attribute) {
    if (!extension.Has("attributes") || !extension.Get("attributes").Has(attribute)) {
        return -1;
    }
    const tinygltf::Value& value = extension.Get("attributes").Get(attribute);
    return value.IsNumber() ? value.GetNumberAsInt() : -1;
}

/// Returns what the integers of a normalised accessor are divided by; 1 for all others.
float divisorFor(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                 const std::string& attribute) {
    const auto index = primitive.attributes.find(attribute);
    if (index == primitive.attributes.end() || index->second < 0 ||
        std::size_t(index->second) >= model.accessors.size() ||
        !model.accessors[std::size_t(index->second)].normalized) {
        return 1.0f;
    }
    switch (model.accessors[std::size_t(index->second)].componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return 127.0f;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 255.0f;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return 32767.0f;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 65535.0f;
    default:
        return 1.0f;
    }
}

template <class Vector>
std::vector<Vector> valuesOf(const draco::Mesh& mesh, int identifier, float divisor) {
    constexpr int components = Vector::length();
    const draco::PointAttribute* const attribute =
        identifier < 0 ? nullptr : mesh.GetAttributeByUniqueId(std::uint32_t(identifier));
    if (attribute == nullptr || attribute->num_components() != components) {
        return {};
    }
    const bool divide = !attribute->normalized(); // a normalised one is divided by Draco
    std::vector<Vector> values(mesh.num_points());
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
        std::array<float, components> value{};
        attribute->ConvertValue<float>(attribute->mapped_index(point), components, value.data());
        Vector& target = values[point.value()];
        std::copy_n(value.begin(), components, glm::value_ptr(target));
        target = divide ? target / divisor : target;
    }
    return values;
}

std::vector<std::uint32_t> indicesOf(const draco::Mesh& mesh) {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t(mesh.num_faces()) * 3);
    for (draco::FaceIndex i(0); i < mesh.num_faces(); ++i) {
        for (const draco::PointIndex& corner : mesh.face(i)) {
            indices.push_back(corner.value());
        }
    }
    return indices;
}

} // namespace

bool isDraco(const tinygltf::Primitive& primitive) {
    return primitive.extensions.contains(dracoExtension);
}

Result<RawMesh> readDraco(const tinygltf::Model& model, GltfViews& views,
                          const tinygltf::Primitive& primitive) {
    const tinygltf::Value& extension = primitive.extensions.at(dracoExtension);
    const bool hasView = extension.Has("bufferView") && extension.Get("bufferView").IsNumber();
    const auto view = views.view(hasView ? extension.Get("bufferView").GetNumberAsInt() : -1);
    if (!view) {
        return tl::unexpected(view.error());
    }
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(view->bytes.data()), view->bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) {
        return failure("the Draco data is damaged: " + decoded.status().error_msg_string());
    }
    const draco::Mesh& mesh = *decoded.value();
    RawMesh raw;
    const auto read = [&](const char* attribute, auto& target) {
        using Vector = typename std::remove_reference_t<decltype(target)>::value_type;
        target = valuesOf<Vector>(mesh, identifierOf(extension, attribute),
                                  divisorFor(model, primitive, attribute));
    };
    read("POSITION", raw.positions);
    read("NORMAL", raw.normals);
    read("TANGENT", raw.tangents);
    read("TEXCOORD_0", raw.uvs);
    read("COLOR_0", raw.colors);
    if (raw.colors.empty()) {
        std::vector<glm::vec3> opaque;
        read("COLOR_0", opaque);
        raw.colors = withAlpha(opaque);
    }
    raw.indices = indicesOf(mesh);
    const auto outside = [&](std::uint32_t index) { return index >= raw.positions.size(); };
    if (std::ranges::any_of(raw.indices, outside)) {
        return failure("the Draco data has no usable positions");
    }
    return raw;
}

} // namespace patina
