// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace patina {

/// Is what some programs put before text in UTF-8.
inline constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

/// Returns the first `bytes` bytes of a file, or fewer where it ends before; empty when it cannot
/// be read.
std::string startOf(const std::filesystem::path& file, std::size_t bytes);

bool startsWithMark(const std::filesystem::path& file);

/// Returns the file's bytes without a byte order mark; nothing when it is empty or cannot be read.
std::optional<std::string> textOf(const std::filesystem::path& file);

} // namespace patina
