// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_file.h"

#include "core/ordinary_file.h"

namespace patina {

std::string startOf(const std::filesystem::path& file, std::size_t bytes) {
    return OrdinaryFile::open(file, maxAssetBytes)
        .and_then([bytes](const OrdinaryFile& opened) { return opened.start(bytes); })
        .value_or(std::string());
}

bool startsWithMark(const std::filesystem::path& file) {
    return startOf(file, byteOrderMark.size()) == byteOrderMark;
}

std::optional<std::string> textOf(const std::filesystem::path& file) {
    auto text = readFile(file, maxAssetBytes);
    if (!text || text->empty()) {
        return std::nullopt;
    }
    if (text->starts_with(byteOrderMark)) {
        text->erase(0, byteOrderMark.size());
    }
    return std::move(*text);
}

} // namespace patina
