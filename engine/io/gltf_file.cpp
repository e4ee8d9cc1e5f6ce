// SPDX-License-Identifier: GPL-3.0-or-later
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include "io/gltf_file.h"
#include "io/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace patina {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uint32_t glbMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t jsonChunk = 0x4e4f534a; // "JSON"
constexpr std::size_t glbHeaderBytes = 12;
constexpr std::size_t chunkHeaderBytes = 8;

std::uint32_t wordAt(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    if (offset + sizeof word <= bytes.size()) {
        std::memcpy(&word, bytes.data() + offset, sizeof word);
    }
    return word;
}

void appendWord(std::string& bytes, std::size_t word) {
    const auto narrow = static_cast<std::uint32_t>(word);
    bytes.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
}

/// Refers to the parts of a file: the JSON text, and for GLB what follows it.
struct Parts {
    bool binary = false;
    std::string_view json;
    std::string_view chunks; ///< are the chunks after the first, with their headers
};

Result<Parts> taken(std::string_view bytes) {
    if (wordAt(bytes, 0) != glbMagic) {
        return Parts{false, bytes, {}};
    }
    const std::size_t jsonBytes = wordAt(bytes, glbHeaderBytes);
    const std::size_t start = glbHeaderBytes + chunkHeaderBytes;
    if (wordAt(bytes, glbHeaderBytes + 4) != jsonChunk || start > bytes.size() ||
        jsonBytes > bytes.size() - start) {
        return failure("is cut short or damaged", "a GLB header and a whole JSON chunk");
    }
    return Parts{true, bytes.substr(start, jsonBytes), bytes.substr(start + jsonBytes)};
}

std::string glbOf(const std::string& text, std::string_view chunks) {
    std::string padded = text;
    padded.resize((padded.size() + 3) / 4 * 4, ' ');
    std::string bytes;
    appendWord(bytes, glbMagic);
    appendWord(bytes, 2);
    appendWord(bytes, glbHeaderBytes + chunkHeaderBytes + padded.size() + chunks.size());
    appendWord(bytes, padded.size());
    appendWord(bytes, jsonChunk);
    bytes += padded;
    bytes += chunks;
    return bytes;
}

/// Gives one byte to each buffer that exists only for readers that cannot decompress: it has no
/// data, but tinygltf insists on some. Returns whether there was such a buffer.
bool fillFallbackBuffers(json& document, bool binary) {
    bool changed = false;
    const auto buffers = document.find("buffers");
    for (std::size_t i = 0; buffers != document.end() && i < buffers->size(); ++i) {
        json& buffer = (*buffers)[i];
        const bool isChunk = binary && i == 0;
        if (buffer.is_object() && !buffer.contains("uri") && !isChunk &&
            buffer.contains("extensions")) {
            buffer["uri"] = "data:application/octet-stream;base64,AA==";
            buffer["byteLength"] = 1;
            changed = true;
        }
    }
    return changed;
}

/// Removes the indices of compressed primitives: they are described without a buffer view, which
/// tinygltf refuses, and the compressed data has them anyway. Returns whether there were any.
bool dropCompressedIndices(json& document) {
    const json::json_pointer compression("/extensions/KHR_draco_mesh_compression");
    bool changed = false;
    const auto meshes = document.find("meshes");
    for (std::size_t i = 0; meshes != document.end() && i < meshes->size(); ++i) {
        json& mesh = (*meshes)[i];
        if (!mesh.is_object() || !mesh.contains("primitives")) {
            continue;
        }
        for (json& primitive : mesh["primitives"]) {
            if (primitive.is_object() && primitive.contains(compression)) {
                changed |= primitive.erase("indices") > 0;
            }
        }
    }
    return changed;
}

/// Tells whether a path is relative, leads not upwards, and has nothing that a shell or another
/// system reads otherwise.
bool uriStaysInFolder(const std::string& uri) {
    const fs::path path = fs::path(withoutEscapes(uri)).lexically_normal();
    return !path.empty() && path.is_relative() && *path.begin() != ".." &&
           path.string().find_first_of("\\$`") == std::string::npos;
}

Error outside(const std::string& uri) {
    return refusal("buffer", uri);
}

/// Refuses buffers outside the folder unless the user allowed them, so that the author of a mesh
/// does not decide which of the user's files are read.
Result<void> checkBuffers(const json& document, MeshFolder& folder) {
    const auto buffers = document.find("buffers");
    for (std::size_t i = 0; buffers != document.end() && i < buffers->size(); ++i) {
        const json& buffer = (*buffers)[i];
        const std::string uri =
            buffer.is_object() && buffer.contains("uri") && buffer["uri"].is_string()
                ? buffer["uri"].get<std::string>()
                : std::string();
        const bool isOutside = !uri.empty() && !uri.starts_with("data:") && !uriStaysInFolder(uri);
        if (isOutside && !folder.rights().everything && !folder.open(withoutEscapes(uri))) {
            return tl::unexpected(outside(uri));
        }
    }
    return {};
}

/// Changes what is valid but not accepted by tinygltf. Returns whether something was changed.
bool adaptForLibrary(json& document, bool binary) {
    const bool buffers = fillFallbackBuffers(document, binary);
    const bool primitives = dropCompressedIndices(document);
    return buffers || primitives;
}

/// Tells whether an extension can be read or ignored. Those for materials, textures, lights and
/// animations do not matter here.
bool isKnown(const std::string& extension) {
    constexpr std::array<std::string_view, 5> harmless{"KHR_lights_", "KHR_animation",
                                                       "KHR_technique", "KHR_xmp", "EXT_lights_"};
    const auto starts = [&](std::string_view prefix) { return extension.starts_with(prefix); };
    return isReadExtension(extension) || isOfMaterials(extension) ||
           std::ranges::any_of(harmless, starts);
}

Result<void> checkRequired(const tinygltf::Model& model) {
    for (const std::string& extension : model.extensionsRequired) {
        if (!isKnown(extension)) {
            return failure("needs the glTF extension " + extension + ", which is not known here");
        }
    }
    return {};
}

std::string firstLine(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    return line.empty() ? "is not valid glTF" : "is not valid glTF: " + line;
}

/// Keeps the bytes of an image that lies in the file; others are read from where they lie.
bool keepImage(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
               const unsigned char* bytes, int size, void*) {
    if (image->uri.empty() && bytes != nullptr && size > 0) {
        image->image.assign(bytes, bytes + size);
    }
    return true;
}

bool isThere(const std::string& path, void* folder) {
    return static_cast<MeshFolder*>(folder)->open(path).has_value();
}

std::string asItIs(const std::string& path, void*) {
    return path;
}

bool readWhole(std::vector<unsigned char>* bytes, std::string* why, const std::string& path,
               void* folder) {
    const auto content = static_cast<MeshFolder*>(folder)->open(path).and_then(
        [](const OrdinaryFile& file) { return file.content(); });
    if (!content) {
        *why = content.error().problem;
        return false;
    }
    bytes->assign(content->begin(), content->end());
    return true;
}

bool writeNothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

Result<tinygltf::Model> parsed(const std::string& bytes, bool binary, MeshFolder& folder) {
    const std::string fromTheFolder;
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keepImage, nullptr);
    loader.SetStoreOriginalJSONForExtrasAndExtensions(true); // it rounds none of their numbers
    loader.SetFsCallbacks({isThere, asItIs, readWhole, writeNothing, &folder});
    tinygltf::Model model;
    std::string errors;
    std::string warnings;
    const auto size = static_cast<unsigned int>(bytes.size());
    const bool loaded =
        binary ? loader.LoadBinaryFromMemory(&model, &errors, &warnings,
                                             reinterpret_cast<const unsigned char*>(bytes.data()),
                                             size, fromTheFolder)
               : loader.LoadASCIIFromString(&model, &errors, &warnings, bytes.data(), size,
                                            fromTheFolder);
    if (!loaded && !folder.refused().empty()) {
        return tl::unexpected(outside(folder.refused().front().path));
    }
    if (!loaded) {
        return failure(firstLine(errors));
    }
    return model;
}

bool isVersionOne(const json& document) {
    const json::json_pointer version("/asset/version");
    if (!document.is_object() || !document.contains(version)) {
        return false;
    }
    const json& value = document.at(version);
    return (value.is_string() && value.get_ref<const std::string&>().starts_with("1")) ||
           (value.is_number() && value.get<double>() < 2.0);
}

} // namespace

std::string withoutEscapes(std::string_view uri) {
    std::string plain;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned int code = 0;
        const char* const digits = uri.data() + i + 1;
        const bool isEscape = uri[i] == '%' && i + 2 < uri.size() &&
                              std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
        plain += isEscape ? static_cast<char>(code) : uri[i];
        i += isEscape ? 2 : 0;
    }
    return plain;
}

Result<std::optional<tinygltf::Model>> loadGltf(MeshFolder& folder) {
    auto bytes = folder.open(folder.file().string()).and_then([](const OrdinaryFile& file) {
        return file.content();
    });
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    if (wordAt(*bytes, 0) == glbMagic && wordAt(*bytes, 4) == 1) {
        return std::optional<tinygltf::Model>();
    }
    const auto parts = taken(*bytes);
    if (!parts) {
        return tl::unexpected(parts.error());
    }
    json document = json::parse(parts->json, nullptr, false);
    if (!document.is_object()) {
        return failure("is not valid glTF", "a JSON object");
    }
    if (isVersionOne(document)) {
        return std::optional<tinygltf::Model>();
    }
    if (auto checked = checkBuffers(document, folder); !checked) {
        return tl::unexpected(checked.error());
    }
    if (adaptForLibrary(document, parts->binary)) {
        const std::string text = document.dump();
        *bytes = parts->binary ? glbOf(text, parts->chunks) : text;
    }
    auto model = parsed(*bytes, wordAt(*bytes, 0) == glbMagic, folder);
    if (!model) {
        return tl::unexpected(model.error());
    }
    return checkRequired(*model).map([&] { return std::optional(std::move(*model)); });
}

} // namespace patina
