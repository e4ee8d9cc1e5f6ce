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
    warmImages = 1, ///< client asks to load the image formats in the background
    readMesh,       ///< client sends texts {file, paths of links that may be read} and numbers
                    ///< {scale, fitUnitBox, flipNormals, byMaterial, whether every link may be
                    ///< read}
    readImage,      ///< client sends texts {file}, and numbers {1} when it wants the numbers of the
                    ///< file, not decoded
    writeImage,     ///< client sends texts {file} and attaches an image block
    encodeImage,    ///< client sends texts {extension} and attaches an image block
    progress,       ///< process sends numbers {done}, 0 .. 1
    done,           ///< process sends texts {remarks, paths of links that were refused} and
                    ///< attaches the block of the answer, if it has one
    failed,         ///< process sends texts {problem, expected, the same paths} and numbers {line,
                    ///< column}
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
