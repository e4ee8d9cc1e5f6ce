// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_file.h"

#include <array>
#include <fstream>

namespace patina {

bool startsWithMark(const std::filesystem::path& file) {
    std::array<char, byteOrderMark.size()> start{};
    std::ifstream(file, std::ios::binary).read(start.data(), start.size());
    return std::string_view(start.data(), start.size()) == byteOrderMark;
}

std::optional<std::string> textOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    const auto size = stream.tellg();
    if (!stream || size <= 0) {
        return std::nullopt;
    }
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!stream.seekg(0).read(text.data(), size)) {
        return std::nullopt;
    }
    if (text.starts_with(byteOrderMark)) {
        text.erase(0, byteOrderMark.size());
    }
    return text;
}

} // namespace patina
