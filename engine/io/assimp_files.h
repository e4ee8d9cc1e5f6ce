// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <assimp/IOSystem.hpp>

#include "io/mesh_folder.h"

namespace patina {

/// Gives Assimp the files of a mesh's folder and no others.
class AssimpFiles final : public Assimp::IOSystem {
  public:
    explicit AssimpFiles(std::shared_ptr<MeshFolder> folder) : folder_(std::move(folder)) {}

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    // Assimp's readers get no right to write.
    bool CreateDirectory(const std::string&) override { return false; }
    bool ChangeDirectory(const std::string&) override { return false; }
    bool DeleteFile(const std::string&) override { return false; }

  private:
    std::shared_ptr<MeshFolder> folder_;
};

} // namespace patina
