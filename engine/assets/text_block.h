// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/error.h"

namespace patina {

/// Defines how plain bytes (an encoded picture) lie in a shared block: a 16-byte header, then the
/// bytes.
class TextBlock {
  public:
    static std::size_t sizeFor(std::size_t length);

    /// Writes the text into a block of sizeFor(...) bytes.
    static void write(std::span<std::byte> block, std::string_view text);

    /// Copies the bytes that another process wrote. Fails when the header or their number does not
    /// match the block.
    static Result<std::string> checked(std::span<const std::byte> block);
};

} // namespace patina
