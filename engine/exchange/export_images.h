// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "material/texture_use.h"

namespace patina {

/// Is a file of an export, by its path from the export's folder, with forward slashes.
struct ExportedFile {
    std::string path;
    std::string bytes;
};

/// Collects the images that go with an export, each once, in a folder beside the exported file.
class ExportImages {
  public:
    /// `folder` is the name of the folder that they lie in.
    explicit ExportImages(std::string folder) : folder_(std::move(folder)) {}

    /// Takes an image and returns its path from the exported file. It is an error where it cannot
    /// be read, or where its name has none of the endings that a format can show.
    Result<std::string> add(const std::string& file, const std::vector<std::string_view>& endings);

    /// Is an image of which one channel counts.
    struct Numbers {
        TextureUse use;
        TextureChannel channel = TextureChannel::Auto;
    };

    /// Makes an image of metalness and roughness as glTF has it, the square roots of the widths in
    /// green and the metalness in blue, 1 for what is not there; an image that is so already is
    /// taken as it is. Returns its path as add() does.
    Result<std::string> addMetallicRoughness(const std::optional<Numbers>& widths,
                                             const std::optional<Numbers>& metalness);

    /// Returns the path from the exported file of an image that was taken; null where it was not.
    const std::string* pathOf(const std::string& file) const {
        const auto known = paths_.find(file);
        return known == paths_.end() ? nullptr : &known->second;
    }

    /// Returns the content of an image that was taken, by what add() returned.
    const std::string& bytes(const std::string& path) const {
        return files_[places_.at(path)].bytes;
    }

    const std::vector<ExportedFile>& files() const { return files_; }

  private:
    std::string take(const std::string& stem, const std::string& ending, std::string bytes);

    std::string folder_;
    std::vector<ExportedFile> files_;
    std::map<std::string, std::size_t> places_; ///< maps a path to its place in `files_`
    std::map<std::string, std::string> made_;   ///< maps what an image was made of to its path
    std::map<std::string, std::string> paths_;  ///< maps a file to its path in the export
};

/// Returns the name's ending in lower case, with its dot.
std::string endingOf(const std::filesystem::path& file);

} // namespace patina
