// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace patina::tests {

/// Builds GLB files piece by piece: one buffer, and a view for each piece of data.
class GlbWriter {
  public:
    GlbWriter() {
        document["asset"]["version"] = "2.0";
        document["scenes"][0]["nodes"] = nlohmann::json::array({0});
        document["nodes"][0]["mesh"] = 0;
        document["meshes"][0]["primitives"][0] = nlohmann::json::object();
        document["accessors"] = nlohmann::json::array();
        document["bufferViews"] = nlohmann::json::array();
    }

    /// Appends data as a buffer view of its own and returns the view's index.
    template <class T>
    int addView(const std::vector<T>& values) {
        const std::size_t bytes = values.size() * sizeof(T);
        document["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", bytes}});
        data_.append(reinterpret_cast<const char*>(values.data()), bytes);
        data_.resize((data_.size() + 3) / 4 * 4, '\0');
        return static_cast<int>(document["bufferViews"].size()) - 1;
    }

    /// Describes a view (-1: none) as `count` elements and returns the accessor's index.
    int addAccessor(int view, int componentType, const char* type, std::size_t count) {
        nlohmann::json accessor{{"componentType", componentType}, {"type", type}, {"count", count}};
        if (view >= 0) {
            accessor["bufferView"] = view;
        }
        document["accessors"].push_back(accessor);
        return static_cast<int>(document["accessors"].size()) - 1;
    }

    nlohmann::json& primitive() { return document["meshes"][0]["primitives"][0]; }
    nlohmann::json& node() { return document["nodes"][0]; }

    std::string bytes() const {
        nlohmann::json whole = document;
        whole["buffers"][0]["byteLength"] = data_.size();
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return "glTF" + word(2) + word(28 + text.size() + data_.size()) + word(text.size()) +
               "JSON" + text + word(data_.size()) + std::string("BIN\0", 4) + data_;
    }

    nlohmann::json document;

  private:
    static std::string word(std::size_t value) {
        const auto narrow = static_cast<std::uint32_t>(value);
        std::string bytes(sizeof narrow, '\0');
        std::memcpy(bytes.data(), &narrow, sizeof narrow);
        return bytes;
    }

    std::string data_;
};

} // namespace patina::tests
