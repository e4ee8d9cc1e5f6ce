// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/ordinary_file.h"

namespace patina {

/// A mesh file and all that may be read for it: what lies in its folder or below, whatever links
/// and names the file gives. Whoever sent a mesh does not decide which of the user's files are
/// read.
class MeshFolder {
  public:
    explicit MeshFolder(std::filesystem::path file);
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;
    ~MeshFolder();

    /// The mesh file itself, or one that it names: as a full path, or from its folder.
    Result<OrdinaryFile> open(const std::string& path);

    /// What was asked for, is there, and lies outside; each once.
    const std::vector<std::string>& refused() const { return refused_; }

    const std::filesystem::path& file() const { return file_; }

  private:
    std::filesystem::path file_;
    int folder_;
    std::vector<std::string> refused_;
};

/// Such a file is not read.
Error refusal(const std::string& path);

} // namespace patina
