// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patina {

/// Names what a message between the client and the files process asks or answers, and its content.
enum class MessageKind : std::uint32_t {
    warmImages = 1, ///< client: load the image formats in the background
    readMesh,       ///< client: texts {file, paths of links that may be read}; numbers {scale,
                    ///< fitUnitBox, flipNormals, whether every link may}
    readImage,      ///< client: texts {file}; numbers {1}: as it is in the file
    writeImage,     ///< client: texts {file}; an image block is attached
    encodeImage,    ///< client: texts {extension}; an image block is attached
    progress,       ///< process: numbers {done}
    done,           ///< process: texts {remarks, paths of links that it was refused}; the
                    ///< answer's block is attached where there is one
    failed,         ///< process: texts {problem, expected, the same paths}; numbers {line, column}
};

/// Holds a small message: a kind, some numbers, some texts. Bulk data travels in a shared block.
struct Message {
    MessageKind kind = MessageKind::progress;
    std::vector<double> numbers;
    std::vector<std::string> texts;

    friend bool operator==(const Message&, const Message&) = default;
};

/// Joins paths into one text, each with an end mark, so that splitPaths() drops a path that was
/// cut.
std::string joinedPaths(std::span<const std::string> paths);
std::vector<std::string> splitPaths(std::string_view joined);

/// bytes
inline constexpr std::size_t maxMessageBytes = std::size_t(64) * 1024;

/// Returns the bytes to send. Long texts are cut, so that the whole stays within maxMessageBytes.
std::string encoded(const Message& message);

/// Returns the message in these bytes; nothing when they are not exactly one valid message.
std::optional<Message> decodedMessage(std::span<const std::byte> bytes);

} // namespace patina
