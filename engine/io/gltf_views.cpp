// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_views.h"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <meshoptimizer.h>

namespace patina {
namespace {

constexpr const char* meshoptExtension = "EXT_meshopt_compression";
constexpr std::size_t maxViewBytes = std::size_t(1) << 30;

/// Holds the fields of the extension object, under the names of its specification.
struct Compression {
    int buffer = 0;
    std::size_t byteOffset = 0;
    std::size_t byteLength = 0;
    std::size_t byteStride = 0;
    std::size_t count = 0;
    std::string mode;
    std::string filter;
};

std::size_t sizeIn(const tinygltf::Value& object, const std::string& key) {
    if (!object.Has(key) || !object.Get(key).IsNumber()) {
        return 0;
    }
    const double value = object.Get(key).GetNumberAsDouble();
    return value > 0.0 && value < 4294967296.0 ? static_cast<std::size_t>(value) : 0;
}

std::string textIn(const tinygltf::Value& object, const std::string& key) {
    return object.Has(key) && object.Get(key).IsString() ? object.Get(key).Get<std::string>()
                                                         : std::string();
}

Compression compressionFrom(const tinygltf::Value& object) {
    return {static_cast<int>(sizeIn(object, "buffer")),
            sizeIn(object, "byteOffset"),
            sizeIn(object, "byteLength"),
            sizeIn(object, "byteStride"),
            sizeIn(object, "count"),
            textIn(object, "mode"),
            textIn(object, "filter")};
}

/// Checks what the specification demands, since the library asserts it.
bool isValid(const Compression& c) {
    if (c.count == 0 || c.byteStride == 0 || c.count > maxViewBytes / c.byteStride) {
        return false;
    }
    if (c.mode == "ATTRIBUTES") {
        return c.byteStride % 4 == 0 && c.byteStride <= 256;
    }
    const bool indices = c.byteStride == 2 || c.byteStride == 4;
    return indices && (c.mode == "INDICES" || (c.mode == "TRIANGLES" && c.count % 3 == 0));
}

bool decode(const Compression& c, std::span<const unsigned char> source, unsigned char* target) {
    if (c.mode == "ATTRIBUTES") {
        return meshopt_decodeVertexBuffer(target, c.count, c.byteStride, source.data(),
                                          source.size()) == 0;
    }
    if (c.mode == "TRIANGLES") {
        return meshopt_decodeIndexBuffer(target, c.count, c.byteStride, source.data(),
                                         source.size()) == 0;
    }
    return meshopt_decodeIndexSequence(target, c.count, c.byteStride, source.data(),
                                       source.size()) == 0;
}

bool applyFilter(const Compression& c, unsigned char* target) {
    if (c.filter.empty() || c.filter == "NONE") {
        return true;
    }
    if (c.filter == "OCTAHEDRAL" && (c.byteStride == 4 || c.byteStride == 8)) {
        meshopt_decodeFilterOct(target, c.count, c.byteStride);
        return true;
    }
    if (c.filter == "QUATERNION" && c.byteStride == 8) {
        meshopt_decodeFilterQuat(target, c.count, c.byteStride);
        return true;
    }
    if (c.filter == "EXPONENTIAL") {
        meshopt_decodeFilterExp(target, c.count, c.byteStride);
        return true;
    }
    return false;
}

} // namespace

Result<std::span<const unsigned char>> GltfViews::range(int buffer, std::size_t offset,
                                                        std::size_t length) const {
    if (buffer < 0 || std::size_t(buffer) >= model_.buffers.size()) {
        return failure(fmt::format("there is no buffer {}", buffer));
    }
    const auto& data = model_.buffers[std::size_t(buffer)].data;
    if (offset > data.size() || length > data.size() - offset) {
        return failure(fmt::format("buffer {} is too short: {} bytes, {} needed", buffer,
                                   data.size(), offset + length));
    }
    return std::span(data).subspan(offset, length);
}

Result<GltfViews::View> GltfViews::view(int index) {
    if (index < 0 || std::size_t(index) >= model_.bufferViews.size()) {
        return failure(fmt::format("there is no buffer view {}", index));
    }
    const tinygltf::BufferView& view = model_.bufferViews[std::size_t(index)];
    const auto extension = view.extensions.find(meshoptExtension);
    if (extension != view.extensions.end()) {
        return decompressed(index, extension->second);
    }
    return range(view.buffer, view.byteOffset, view.byteLength).map([&](auto bytes) {
        return View{bytes, view.byteStride};
    });
}

Result<GltfViews::View> GltfViews::decompressed(int index, const tinygltf::Value& extension) {
    const Compression compression = compressionFrom(extension);
    const std::size_t stride = compression.byteStride;
    if (const auto known = decompressed_.find(index); known != decompressed_.end()) {
        return View{known->second, stride};
    }
    if (!isValid(compression)) {
        return failure(fmt::format("the compression of buffer view {} is not valid", index));
    }
    const auto source = range(compression.buffer, compression.byteOffset, compression.byteLength);
    if (!source) {
        return tl::unexpected(source.error());
    }
    std::vector<unsigned char> bytes(compression.count * stride);
    if (!decode(compression, *source, bytes.data()) || !applyFilter(compression, bytes.data())) {
        return failure(fmt::format("the compressed data of buffer view {} is damaged", index));
    }
    return View{decompressed_.emplace(index, std::move(bytes)).first->second, stride};
}

} // namespace patina
