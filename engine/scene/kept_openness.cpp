// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/kept_openness.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "catalog/xdg_folders.h"
#include "core/atomic_file.h"
#include "core/mesh_openness.h"
#include "core/ordinary_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Begins every file; files with another beginning are not read. It must change whenever
/// opennessOf() returns other values.
constexpr std::string_view magic = "patina openness 1\n";

constexpr std::uintmax_t folderBytes = std::uintmax_t(256) << 20;

/// Returns an FNV-1a hash that takes eight bytes at a time, with a shift that mixes the upper bits
/// into the lower ones. It begins with `hash`.
std::uint64_t hashOf(std::span<const std::byte> bytes, std::uint64_t hash) {
    while (!bytes.empty()) {
        std::uint64_t word = 0;
        const std::size_t count = std::min<std::size_t>(bytes.size(), sizeof(word));
        std::memcpy(&word, bytes.data(), count);
        hash = (hash ^ word) * 0x100000001b3u;
        hash ^= hash >> 29;
        bytes = bytes.subspan(count);
    }
    return hash;
}

std::uint64_t hashOf(const MeshView& mesh, std::uint64_t hash) {
    for (const Vertex& vertex : mesh.vertices) {
        hash = hashOf(std::as_bytes(std::span(&vertex.position, 1)), hash);
        hash = hashOf(std::as_bytes(std::span(&vertex.normal, 1)), hash);
    }
    return hashOf(std::as_bytes(mesh.indices), hash);
}

constexpr std::uint64_t firstSeed = 0xcbf29ce484222325u;
constexpr std::uint64_t secondSeed = 0x9e3779b97f4a7c15u;

/// Reads the openness of so many vertices; nothing where there is no such file or it is damaged.
std::optional<std::vector<VertexOpenness>> read(const fs::path& file, std::size_t vertices) {
    const std::size_t bytes = vertices * sizeof(VertexOpenness);
    const std::size_t whole = magic.size() + bytes + sizeof(std::uint64_t);
    const Result<std::string> content = readFile(file, whole);
    if (!content || content->size() != whole || !content->starts_with(magic)) {
        return std::nullopt;
    }
    std::vector<VertexOpenness> openness(vertices);
    std::uint64_t hash = 0;
    std::memcpy(openness.data(), content->data() + magic.size(), bytes);
    std::memcpy(&hash, content->data() + magic.size() + bytes, sizeof(hash));
    const bool isWhole = hash == hashOf(std::as_bytes(std::span(openness)), firstSeed);
    return isWhole ? std::optional(std::move(openness)) : std::nullopt;
}

/// Removes the folder's oldest files while all together exceed `folderBytes`.
void makeRoom(const fs::path& folder) {
    struct Kept {
        fs::path file;
        std::uintmax_t bytes = 0;
        fs::file_time_type time;
    };
    std::vector<Kept> all;
    std::uintmax_t sum = 0;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        std::error_code gone;
        const Kept kept{entry.path(), entry.file_size(gone), entry.last_write_time(gone)};
        if (!gone) {
            sum += kept.bytes;
            all.push_back(kept);
        }
    }
    std::ranges::sort(all, {}, &Kept::time);
    for (std::size_t i = 0; i < all.size() && sum > folderBytes; ++i) {
        fs::remove(all[i].file, error);
        sum -= all[i].bytes;
    }
}

/// Writes the file. Errors are ignored, since what is not kept is merely computed again.
void keep(std::span<const VertexOpenness> openness, const fs::path& file) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) {
        return;
    }
    makeRoom(file.parent_path());
    const auto bytes = std::as_bytes(openness);
    const std::uint64_t hash = hashOf(bytes, firstSeed);
    std::string content(magic);
    content.append(reinterpret_cast<const char*>(bytes.data()), bytes.size()); // NOLINT: as bytes
    content.append(reinterpret_cast<const char*>(&hash), sizeof(hash));        // NOLINT: as bytes
    static_cast<void>(writeFileAtomically(file, content));
}

} // namespace

fs::path opennessFile(const MeshView& mesh, const fs::path& folder) {
    return folder /
           fmt::format("{:016x}{:016x}", hashOf(mesh, firstSeed), hashOf(mesh, secondSeed));
}

fs::path opennessFolder() {
    const std::optional<fs::path> cache = xdgCacheFolder();
    return cache ? *cache / "openness" : fs::path();
}

std::vector<VertexOpenness> keptOpenness(const MeshView& mesh, const fs::path& folder,
                                         Progress* progress) {
    if (folder.empty()) {
        return opennessOf(mesh, progress);
    }
    const fs::path file = opennessFile(mesh, folder);
    if (auto kept = read(file, mesh.vertices.size())) {
        return std::move(*kept);
    }
    std::vector<VertexOpenness> made = opennessOf(mesh, progress);
    if (!made.empty()) {
        keep(made, file);
    }
    return made;
}

} // namespace patina
