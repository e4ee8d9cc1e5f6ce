// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace patina::tests {

/// Is one text file of the project.
struct SourceFile {
    std::string path; ///< is relative to the project's root, with forward slashes
    std::string text;

    std::string name() const { return std::filesystem::path(path).filename().string(); }
    std::string stem() const { return std::filesystem::path(path).stem().string(); }
    std::string folder() const { return std::filesystem::path(path).parent_path().string(); }
    bool endsWith(std::string_view ending) const { return path.ends_with(ending); }

    /// Returns "path:line" of an offset into the text, for messages.
    std::string place(std::size_t offset) const {
        const auto end = text.begin() + std::ptrdiff_t(std::min(offset, text.size()));
        return path + ":" + std::to_string(std::count(text.begin(), end, '\n') + 1);
    }
};

inline std::filesystem::path projectRoot() {
    return PATINA_SOURCE_DIR;
}

inline std::string readText(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Returns all files under the named folders of the project, sorted by path; only those with one of
/// the endings when any are given.
inline std::vector<SourceFile> filesUnder(std::initializer_list<std::string_view> folders,
                                          std::initializer_list<std::string_view> endings = {}) {
    std::vector<SourceFile> files;
    const auto wanted = [&](const std::string& path) {
        return endings.size() == 0 || std::ranges::any_of(endings, [&](std::string_view ending) {
                   return path.ends_with(ending);
               });
    };
    for (const std::string_view folder : folders) {
        const auto start = projectRoot() / folder;
        if (!std::filesystem::is_directory(start)) {
            continue;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(start)) {
            const auto path = entry.path().lexically_relative(projectRoot()).generic_string();
            if (entry.is_regular_file() && wanted(path)) {
                files.push_back({path, readText(entry.path())});
            }
        }
    }
    std::ranges::sort(files, {}, &SourceFile::path);
    return files;
}

/// Returns the block descriptors that ship, without lib/ and passes/.
inline std::vector<SourceFile> blockDescriptors() {
    return filesUnder({"shaders"}, {".json"});
}

} // namespace patina::tests
