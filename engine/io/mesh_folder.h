// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/ordinary_file.h"

namespace patina {

/// Says what may be read outside a mesh's folder: the user agreed to it.
struct LinkRights {
    bool everything = false;
    std::vector<std::string> files{}; ///< are full paths, links followed
};

/// Holds a mesh file and opens what may be read for it: files in its folder or below, and those
/// outside that the user allowed. The links and names in a mesh file change nothing, so that its
/// author does not decide which of the user's files are read.
class MeshFolder {
  public:
    explicit MeshFolder(std::filesystem::path file, LinkRights rights = {});
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;
    ~MeshFolder();

    /// Opens the mesh file itself, or one that it names by a full path or relative to its folder.
    Result<OrdinaryFile> open(const std::string& path);

    /// Names a file that was asked for and exists, but lies outside and is not allowed.
    struct Refused {
        std::string path;  ///< is the path that was asked for
        std::string place; ///< is the full path of the file, links followed
    };
    const std::vector<Refused>& refused() const { return refused_; } ///< each path is listed once

    const LinkRights& rights() const { return rights_; }
    const std::filesystem::path& file() const { return file_; }

  private:
    bool mayRead(const std::string& path, const std::string& place);

    std::filesystem::path file_;
    LinkRights rights_;
    int folder_;
    std::vector<Refused> refused_;
};

/// Returns the error that says that a file named by the mesh is not read; `what` is "file" or
/// "buffer".
Error refusal(std::string_view what, const std::string& path);
bool isRefusal(const Error& error);

} // namespace patina
