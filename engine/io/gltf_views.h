// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include <tiny_gltf.h>

#include "core/error.h"

namespace patina {

/// Reads the buffer views of a model, with EXT_meshopt_compression undone, every range checked.
class GltfViews {
  public:
    explicit GltfViews(const tinygltf::Model& model) : model_(model) {}

    struct View {
        std::span<const unsigned char> bytes;
        std::size_t stride = 0; ///< 0: tightly packed
    };

    /// Errors: no such view, or it reaches beyond its buffer, or its compressed data is damaged.
    Result<View> view(int index);

  private:
    Result<std::span<const unsigned char>> range(int buffer, std::size_t offset,
                                                 std::size_t length) const;
    Result<View> decompressed(int index, const tinygltf::Value& extension);

    const tinygltf::Model& model_;
    std::map<int, std::vector<unsigned char>> decompressed_;
};

} // namespace patina
