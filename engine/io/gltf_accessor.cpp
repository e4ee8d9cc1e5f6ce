// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include <fmt/format.h>

namespace patina {
namespace {

constexpr std::size_t maxElements = std::size_t(1) << 27;

/// Reads one number. A normalised integer stands for a number in [-1, 1] or [0, 1] (glTF 2.0,
/// section 3.6.2.2).
template <class T>
double valueAt(const unsigned char* bytes, bool normalized) {
    T value{};
    std::memcpy(&value, bytes, sizeof value);
    if constexpr (std::is_integral_v<T>) {
        if (normalized) {
            return std::max(double(value) / double(std::numeric_limits<T>::max()), -1.0);
        }
    }
    return static_cast<double>(value);
}

using ReadValue = double (*)(const unsigned char*, bool);

ReadValue readerFor(int componentType) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return valueAt<std::int8_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return valueAt<std::uint8_t>;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return valueAt<std::int16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return valueAt<std::uint16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return valueAt<std::uint32_t>;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return valueAt<float>;
    default:
        return nullptr;
    }
}

/// Describes consecutive elements somewhere in a buffer view.
struct Source {
    int view = -1;
    std::size_t offset = 0;
    std::size_t count = 0;
    std::size_t components = 0;
    int componentType = 0;
    bool normalized = false;
};

/// Reads the numbers of all elements one after the other. It checks all ranges once, before the
/// loop.
template <class T>
Result<std::vector<T>> elements(GltfViews& views, const Source& source) {
    const ReadValue read = readerFor(source.componentType);
    if (read == nullptr) {
        return failure(fmt::format("component type {} is not valid", source.componentType));
    }
    const auto view = views.view(source.view);
    if (!view) {
        return tl::unexpected(view.error());
    }
    const auto valueBytes =
        std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(source.componentType)));
    const std::size_t elementBytes = valueBytes * source.components;
    const std::size_t stride = view->stride != 0 ? view->stride : elementBytes;
    const std::size_t available = view->bytes.size();
    if (source.offset > available || elementBytes > available - source.offset ||
        source.count - 1 > (available - source.offset - elementBytes) / stride) {
        return failure(
            fmt::format("buffer view {} is too short for {} elements", source.view, source.count));
    }
    std::vector<T> values;
    values.reserve(source.count * source.components);
    for (std::size_t i = 0; i < source.count; ++i) {
        const unsigned char* const element = view->bytes.data() + source.offset + i * stride;
        for (std::size_t c = 0; c < source.components; ++c) {
            values.push_back(static_cast<T>(read(element + c * valueBytes, source.normalized)));
        }
    }
    return values;
}

Result<const tinygltf::Accessor*> accessorAt(const tinygltf::Model& model, int index) {
    if (index < 0 || std::size_t(index) >= model.accessors.size()) {
        return failure(fmt::format("there is no accessor {}", index));
    }
    const tinygltf::Accessor& accessor = model.accessors[std::size_t(index)];
    if (accessor.count == 0 || accessor.count > maxElements) {
        return failure(fmt::format("accessor {} has {} elements", index, accessor.count));
    }
    return &accessor;
}

Source sourceOf(const tinygltf::Accessor& accessor, std::size_t components) {
    return {accessor.bufferView, accessor.byteOffset,    accessor.count,
            components,          accessor.componentType, accessor.normalized};
}

/// Replaces the elements that a sparse accessor lists.
template <class T>
Result<void> applySparse(GltfViews& views, const tinygltf::Accessor& accessor,
                         std::size_t components, std::vector<T>& values) {
    const auto& sparse = accessor.sparse;
    if (!sparse.isSparse || sparse.count <= 0) {
        return {};
    }
    const auto count = std::size_t(sparse.count);
    const auto places = elements<std::uint32_t>(
        views, {sparse.indices.bufferView, std::size_t(std::max(sparse.indices.byteOffset, 0)),
                count, 1, sparse.indices.componentType, false});
    const auto replacements = elements<T>(
        views, {sparse.values.bufferView, std::size_t(std::max(sparse.values.byteOffset, 0)), count,
                components, accessor.componentType, accessor.normalized});
    if (!places || !replacements) {
        return tl::unexpected(places ? replacements.error() : places.error());
    }
    for (std::size_t i = 0; i < count; ++i) {
        if ((*places)[i] >= accessor.count) {
            return failure("a sparse accessor replaces an element that is not there");
        }
        std::copy_n(replacements->begin() + std::ptrdiff_t(i * components), components,
                    values.begin() + std::ptrdiff_t((*places)[i] * components));
    }
    return {};
}

template <class T>
Result<std::vector<T>> values(GltfViews& views, const tinygltf::Accessor& accessor,
                              std::size_t components) {
    // Without a buffer view all values are zero, to be replaced by the sparse ones.
    auto all = accessor.bufferView < 0
                   ? Result<std::vector<T>>(std::vector<T>(accessor.count * components))
                   : elements<T>(views, sourceOf(accessor, components));
    if (!all) {
        return all;
    }
    return applySparse(views, accessor, components, *all).map([&] { return std::move(*all); });
}

} // namespace

Result<std::vector<float>> readFloats(const tinygltf::Model& model, GltfViews& views, int accessor,
                                      std::size_t components) {
    const auto found = accessorAt(model, accessor);
    if (!found) {
        return tl::unexpected(found.error());
    }
    if (tinygltf::GetNumComponentsInType(std::uint32_t((*found)->type)) != int(components)) {
        return failure(
            fmt::format("accessor {} does not have {} components", accessor, components));
    }
    return values<float>(views, **found, components);
}

std::size_t componentsOf(const tinygltf::Model& model, int accessor) {
    const auto found = accessorAt(model, accessor);
    const int components =
        found ? tinygltf::GetNumComponentsInType(std::uint32_t((*found)->type)) : 0;
    return static_cast<std::size_t>(std::max(components, 0));
}

Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, GltfViews& views,
                                               int accessor) {
    const auto found = accessorAt(model, accessor);
    if (!found) {
        return tl::unexpected(found.error());
    }
    const int type = (*found)->componentType;
    if ((*found)->type != TINYGLTF_TYPE_SCALAR || (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
                                                   type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
                                                   type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
        return failure(fmt::format("accessor {} does not hold indices", accessor));
    }
    return values<std::uint32_t>(views, **found, 1);
}

} // namespace patina
