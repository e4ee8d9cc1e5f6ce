// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_folder.h"

#include <algorithm>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace patina {
namespace {

constexpr std::string_view notRead = "lies outside its folder and is not read";

std::filesystem::path folderOf(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

} // namespace

MeshFolder::MeshFolder(std::filesystem::path file, LinkRights rights)
    : file_(std::move(file)), rights_(std::move(rights)),
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
    return OrdinaryFile::openBelow(
        folder_, path, maxAssetBytes,
        [&](const std::filesystem::path& place) { return mayRead(path, place.string()); });
}

/// Decides on a file outside the folder, and remembers those that are refused.
bool MeshFolder::mayRead(const std::string& path, const std::string& place) {
    if (rights_.everything || std::ranges::find(rights_.files, place) != rights_.files.end()) {
        return true;
    }
    if (std::ranges::find(refused_, path, &Refused::path) == refused_.end()) {
        refused_.push_back({path, place});
    }
    return false;
}

Error refusal(std::string_view what, const std::string& path) {
    return Error{{},
                 0,
                 0,
                 fmt::format("its {} \"{}\" {}", what, path, notRead),
                 "a file beside the mesh, or in a folder there"};
}

bool isRefusal(const Error& error) {
    return error.problem.ends_with(notRead);
}

} // namespace patina
