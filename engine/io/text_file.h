// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace patina {

/// What some programs put before text in UTF-8.
inline constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

bool startsWithMark(const std::filesystem::path& file);

/// The file's bytes without a byte order mark; nothing when it is empty or cannot be read.
std::optional<std::string> textOf(const std::filesystem::path& file);

} // namespace patina
