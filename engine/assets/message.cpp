// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/message.h"

#include <algorithm>
#include <cstring>

namespace patina {
namespace {

constexpr std::uint32_t messageMagic = 0x4d544150; // "PATM"
constexpr std::uint32_t messageVersion = 1;
constexpr std::size_t maxNumbers = 16;
constexpr std::size_t maxTexts = 4;
/// Is more than any path (4096) or useful sentence needs; 4 texts of it fit in a message.
constexpr std::size_t maxTextBytes = std::size_t(12) * 1024;

constexpr char pathEnd = '\0';

struct MessageHeader {
    std::uint32_t magic = messageMagic;
    std::uint32_t version = messageVersion;
    std::uint32_t kind = 0;
    std::uint32_t numbers = 0;
    std::uint32_t texts = 0;
};

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Takes values from the front of a byte range; each take() returns false when too few bytes are
/// left.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <class T>
    bool take(T& value) {
        if (rest_.size() < sizeof value) {
            return false;
        }
        std::memcpy(&value, rest_.data(), sizeof value);
        rest_ = rest_.subspan(sizeof value);
        return true;
    }

    bool take(std::string& text, std::size_t size) {
        if (rest_.size() < size) {
            return false;
        }
        text.assign(reinterpret_cast<const char*>(rest_.data()), size);
        rest_ = rest_.subspan(size);
        return true;
    }

    bool atEnd() const { return rest_.empty(); }

  private:
    std::span<const std::byte> rest_;
};

bool plausible(const MessageHeader& header) {
    return header.magic == messageMagic && header.version == messageVersion &&
           header.kind >= static_cast<std::uint32_t>(MessageKind::warmImages) &&
           header.kind <= static_cast<std::uint32_t>(MessageKind::failed) &&
           header.numbers <= maxNumbers && header.texts <= maxTexts;
}

bool takeText(ByteReader& reader, std::string& text) {
    std::uint32_t size = 0;
    return reader.take(size) && size <= maxTextBytes && reader.take(text, size);
}

} // namespace

std::string joinedPaths(std::span<const std::string> paths) {
    std::string joined;
    for (const std::string& path : paths) {
        joined += path;
        joined += pathEnd;
    }
    return joined;
}

std::vector<std::string> splitPaths(std::string_view joined) {
    std::vector<std::string> paths;
    for (std::size_t end = joined.find(pathEnd); end != std::string_view::npos;
         end = joined.find(pathEnd)) {
        paths.emplace_back(joined.substr(0, end));
        joined.remove_prefix(end + 1);
    }
    return paths;
}

std::string encoded(const Message& message) {
    MessageHeader header;
    header.kind = static_cast<std::uint32_t>(message.kind);
    header.numbers = static_cast<std::uint32_t>(std::min(message.numbers.size(), maxNumbers));
    header.texts = static_cast<std::uint32_t>(std::min(message.texts.size(), maxTexts));
    std::string bytes;
    append(bytes, header);
    for (std::size_t i = 0; i < header.numbers; ++i) {
        append(bytes, message.numbers[i]);
    }
    for (std::size_t i = 0; i < header.texts; ++i) {
        const std::size_t size = std::min(message.texts[i].size(), maxTextBytes);
        append(bytes, static_cast<std::uint32_t>(size));
        bytes.append(message.texts[i], 0, size);
    }
    return bytes;
}

std::optional<Message> decodedMessage(std::span<const std::byte> bytes) {
    ByteReader reader(bytes);
    MessageHeader header;
    if (!reader.take(header) || !plausible(header)) {
        return std::nullopt;
    }
    Message message;
    message.kind = static_cast<MessageKind>(header.kind);
    message.numbers.resize(header.numbers);
    message.texts.resize(header.texts);
    const auto takeNumber = [&](double& number) { return reader.take(number); };
    const auto takeString = [&](std::string& text) { return takeText(reader, text); };
    const bool whole = std::ranges::all_of(message.numbers, takeNumber) &&
                       std::ranges::all_of(message.texts, takeString) && reader.atEnd();
    return whole ? std::optional(std::move(message)) : std::nullopt;
}

} // namespace patina
