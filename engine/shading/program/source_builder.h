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

/// Assembles the text of one shader stage. Files are added without their comments, after their
/// includes, each file once.
class SourceBuilder {
  public:
    /// Resolves `#include "lib/..."` relative to `root`.
    explicit SourceBuilder(std::filesystem::path root);

    /// Adds text that is in no file. It ends the text with a newline when there is none.
    void add(std::string_view generated);

    /// Adds a file, by its full path or relative to the root.
    void addFile(const std::filesystem::path& file);

    /// Adds the file of a block, and an error for each mistake that a driver would report only in
    /// the text around it (see blockTextMistakes). What a user's block defines for itself may have
    /// any name (see withPrivateNames).
    void addBlock(const Block& block);

    /// Returns the assembled text; or an error for every file that could not be read (at its
    /// include) and for every mistake of a block.
    Checked<ShaderSource> finish() const;

  private:
    /// Says where a file is included from; empty when the caller added it.
    struct Place {
        std::string file;
        int line = 0;
    };
    void addIncluded(const std::string& name, const Place& includer, const Block* block = nullptr);
    /// Returns the offset where the file itself begins, after what it includes.
    std::size_t addText(const std::string& file, std::string_view text);
    void append(std::string_view line);

    std::filesystem::path root_;
    ShaderSource source_;
    std::set<std::filesystem::path> taken_;
    std::vector<BlockPart> parts_; ///< are the parts of blocks that did not ship
    Errors errors_;
    int lines_ = 0;
};

} // namespace patina
