// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/content_hash.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/ordinary_file.h"
#include "material/preset_file.h"
#include "shading/effects/choice_hash.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Hashes texts one after the other.
class TextHash {
  public:
    void add(std::string_view text) {
        hash_.add(std::uint64_t(text.size()));
        hash_.add(text);
    }

    void addFile(const fs::path& file) { add(readFile(file, maxAssetBytes).value_or("")); }

    std::string text() const { return fmt::format("{:016x}", hash_.value()); }

  private:
    ChoiceHash hash_;
};

/// Returns the ordinary files below a folder, sorted; those that can be listed.
std::vector<fs::path> filesBelow(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator it(folder, options, failed), end; !failed && it != end;
         it.increment(failed)) {
        std::error_code unknown;
        if (it->is_regular_file(unknown)) {
            files.push_back(it->path());
        }
    }
    std::ranges::sort(files);
    return files;
}

} // namespace

std::string presetHash(const std::string& preset, const Catalog& catalog, bool allowsOutside) {
    TextHash hash;
    hash.addFile(preset);
    std::error_code absent; // it is no block's descriptor
    if (const fs::path shader = fs::path(preset).replace_extension(".glsl");
        fs::is_regular_file(shader, absent)) {
        hash.addFile(shader);
    }
    ReadingRights rights;
    rights.everything = allowsOutside;
    if (const auto reading = readPreset(preset, catalog, rights)) {
        for (const fs::path& parent : reading->parents) {
            hash.addFile(parent);
        }
        for (const auto& texture : reading->material.textures) {
            const TextureUse& use = texture.second;
            hash.addFile(use.outside || isVertexColors(use.file) ? std::string() : use.file);
        }
    }
    return hash.text();
}

std::string blocksHash(std::span<const BlockRoot> roots) {
    TextHash hash;
    for (const BlockRoot& root : roots) {
        for (const fs::path& file : filesBelow(root.folder)) {
            hash.add(file.lexically_relative(root.folder).generic_string());
            hash.addFile(file);
        }
    }
    return hash.text();
}

std::string fileHash(const fs::path& file) {
    TextHash hash;
    hash.addFile(file);
    return hash.text();
}

std::string textsHash(std::span<const std::string> texts) {
    TextHash hash;
    for (const std::string& text : texts) {
        hash.add(text);
    }
    return hash.text();
}

} // namespace patina
