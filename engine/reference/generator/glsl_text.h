// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"

namespace patina {

/// Holds one line of shader text and its place.
struct GlslLine {
    std::string file; ///< is the path that #line gives the C++ compiler
    int number = 0;   ///< counts from 1
    std::string text; ///< has no comments
};

using GlslLines = std::vector<GlslLine>;

/// Reads shader text and replaces each include with the file's text, each file once.
class GlslReader {
  public:
    /// Takes the folder `root` in which `#include "lib/..."` is found. Files in `left` are not
    /// read, since C++ replaces them.
    GlslReader(std::filesystem::path root, std::set<std::string> left);

    /// Returns the lines of a file and of what it includes.
    Result<GlslLines> read(const std::filesystem::path& file);

    /// Returns the files that were included or left out, as an #include names them.
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

/// Returns text from no file as C++, without #line.
std::string asCpp(const std::string& text);

/// Returns the lines as one text, without their places.
std::string plainText(const GlslLines& lines);

} // namespace patina
