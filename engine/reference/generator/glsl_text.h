// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"

namespace patina {

/// Represents one line of shader text and where it stands.
struct GlslLine {
    std::string file; ///< as the C++ compiler shall name it
    int number = 0;   ///< 1-based
    std::string text; ///< without comments
};

using GlslLines = std::vector<GlslLine>;

/// Shader text with its includes put in front, each file once.
class GlslReader {
  public:
    /// `root` is the folder that `#include "lib/..."` counts from. Files in `left` are not read:
    /// their place is taken by C++.
    GlslReader(std::filesystem::path root, std::set<std::string> left);

    /// Returns the lines of a file and of what it includes.
    Result<GlslLines> read(const std::filesystem::path& file);

    /// The files that were included or left, as they are named in an #include.
    const std::set<std::string>& taken() const { return taken_; }

  private:
    Result<void> append(const std::filesystem::path& file);

    std::filesystem::path root_;
    std::set<std::string> taken_;
    GlslLines lines_;
};

/// Returns the lines as C++: `float` becomes `double`, and #line names the shader's own file and
/// line.
std::string asCpp(const GlslLines& lines);

/// Returns the same of a text that stands in no file.
std::string asCpp(const std::string& text);

/// Returns the lines as one text, without their places.
std::string plainText(const GlslLines& lines);

} // namespace patina
