// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/export_images.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/ordinary_file.h"

namespace patina {

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char letter) { return std::tolower(letter); });
    return ending;
}

Result<std::string> ExportImages::add(const std::string& file,
                                      const std::vector<std::string_view>& endings) {
    if (const auto known = paths_.find(file); known != paths_.end()) {
        return known->second;
    }
    const std::filesystem::path from(file);
    if (!endings.empty() && std::ranges::find(endings, endingOf(from)) == endings.end()) {
        return failure(fmt::format("the format has no {} images", endingOf(from)));
    }
    auto bytes = readFile(from, maxAssetBytes);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    std::string stem = from.stem().string();
    std::ranges::replace_if(
        stem, [](unsigned char c) { return c < 128 && std::isalnum(c) == 0 && c != '-'; }, '_');
    std::string path = fmt::format("{}/{}{}", folder_, stem, endingOf(from));
    for (int number = 2; places_.contains(path); ++number) {
        path = fmt::format("{}/{}-{}{}", folder_, stem, number, endingOf(from));
    }
    places_[path] = files_.size();
    files_.push_back({path, std::move(*bytes)});
    paths_[file] = path;
    return path;
}

} // namespace patina
