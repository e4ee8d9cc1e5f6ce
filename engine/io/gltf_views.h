// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include <tiny_gltf.h>

#include "core/error.h"

namespace patina {

/// Reads the buffer views of a model, decompresses EXT_meshopt_compression, and checks every range.
class GltfViews {
  public:
    explicit GltfViews(const tinygltf::Model& model) : model_(model) {}

    struct View {
        std::span<const unsigned char> bytes;
        std::size_t stride = 0; ///< bytes between elements; 0: tightly packed
    };

    /// Returns a view, which stays valid as long as this object and the model do. It is an error
    /// when there is no such view, when it reaches beyond its buffer, or when its compressed data
    /// is damaged.
    Result<View> view(int index);

  private:
    Result<std::span<const unsigned char>> range(int buffer, std::size_t offset,
                                                 std::size_t length) const;
    Result<View> decompressed(int index, const tinygltf::Value& extension);

    const tinygltf::Model& model_;
    std::map<int, std::vector<unsigned char>> decompressed_;
};

} // namespace patina
