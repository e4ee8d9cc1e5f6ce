// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/block.h"
#include "core/error.h"
#include "shading/glsl/private_names.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Puts the text of one shader stage together. Files go in without their comments, with their
/// includes before them, each file once.
class SourceBuilder {
  public:
    /// `root` is the folder that `#include "lib/..."` counts from.
    explicit SourceBuilder(std::filesystem::path root);

    /// Text that no file holds. Ends it with a newline when it has none.
    void add(std::string_view generated);

    /// Adds a file, absolute or below the root.
    void addFile(const std::filesystem::path& file);

    /// The file of a block, with an error for what would be wrong only in the text around it (see
    /// blockTextMistakes). What a user's defines for itself may have any name (see
    /// withPrivateNames).
    void addBlock(const Block& block);

    /// Returns what was put together; or every file that could not be read (with the place of its
    /// include), and the blocks' mistakes.
    Checked<ShaderSource> finish() const;

  private:
    /// Says where a file is included from; nowhere: it was asked for.
    struct Place {
        std::string file;
        int line = 0;
    };
    void addIncluded(const std::string& name, const Place& includer, const Block* block = nullptr);
    /// The byte where the file itself begins, behind what it includes.
    std::size_t addText(const std::string& file, std::string_view text);
    void append(std::string_view line);

    std::filesystem::path root_;
    ShaderSource source_;
    std::set<std::filesystem::path> taken_;
    std::vector<BlockPart> parts_; ///< the users' blocks
    Errors errors_;
    int lines_ = 0;
};

} // namespace patina
