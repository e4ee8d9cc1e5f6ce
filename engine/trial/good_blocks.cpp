// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/good_blocks.h"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxFiles = 1000;

void removeOldest(const fs::path& folder) {
    std::error_code failed;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
        files.emplace_back(entry.last_write_time(failed), entry.path());
    }
    if (files.size() <= maxFiles) {
        return;
    }
    std::sort(files.begin(), files.end());
    files.resize(files.size() - maxFiles);
    for (const auto& [time, file] : files) {
        fs::remove(file, failed);
    }
}

} // namespace

bool GoodBlocks::has(const std::string& key) const {
    std::error_code failed;
    return !folder_.empty() && fs::is_regular_file(folder_ / key, failed);
}

void GoodBlocks::add(const std::string& key) const {
    if (folder_.empty()) {
        return;
    }
    std::error_code failed;
    fs::create_directories(folder_, failed);
    const std::ofstream made(folder_ / key);
    removeOldest(folder_);
}

} // namespace patina
