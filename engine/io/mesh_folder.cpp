// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_folder.h"

#include <algorithm>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace patina {
namespace {

std::filesystem::path folderOf(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

} // namespace

MeshFolder::MeshFolder(std::filesystem::path file)
    : file_(std::move(file)),
      folder_(::open(folderOf(file_).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {}

MeshFolder::~MeshFolder() {
    if (folder_ >= 0) {
        ::close(folder_);
    }
}

Result<OrdinaryFile> MeshFolder::open(const std::string& path) {
    if (path == file_.string()) { // it may be a link, as the user likes
        return OrdinaryFile::open(file_, maxAssetBytes);
    }
    auto opened = OrdinaryFile::openBelow(folder_, path, maxAssetBytes);
    if (!opened && leadsOutside(opened.error()) &&
        std::ranges::find(refused_, path) == refused_.end()) {
        refused_.push_back(path);
    }
    return opened;
}

Error refusal(const std::string& path) {
    return Error{{},
                 0,
                 0,
                 "its file \"" + path + "\" lies outside its folder and is not read",
                 "a file beside the mesh, or in a folder there"};
}

} // namespace patina
