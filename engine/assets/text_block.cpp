// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/text_block.h"

#include <cstdint>
#include <cstring>

namespace patina {
namespace {

constexpr std::uint32_t textMagic = 0x54585450; // "PTXT"
constexpr std::uint32_t textVersion = 1;

struct TextHeader {
    std::uint32_t magic = textMagic;
    std::uint32_t version = textVersion;
    std::uint64_t length = 0;
};
static_assert(sizeof(TextHeader) == 16);

} // namespace

std::size_t TextBlock::sizeFor(std::size_t length) { return sizeof(TextHeader) + length; }

void TextBlock::write(std::span<std::byte> block, std::string_view text) {
    TextHeader header;
    header.length = text.size();
    std::memcpy(block.data(), &header, sizeof header);
    std::memcpy(block.data() + sizeof header, text.data(), text.size());
}

Result<std::string> TextBlock::checked(std::span<const std::byte> block) {
    TextHeader header;
    if (block.size() < sizeof header) {
        return failure("the text block is shorter than its header");
    }
    std::memcpy(&header, block.data(), sizeof header);
    if (header.magic != textMagic || header.version != textVersion ||
        header.length != block.size() - sizeof header) {
        return failure("the text block does not have the size it claims");
    }
    return std::string(reinterpret_cast<const char*>(block.data()) + sizeof header, header.length);
}

} // namespace patina
