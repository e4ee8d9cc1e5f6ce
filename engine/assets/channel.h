// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include <tl/expected.hpp>

#include "assets/file_handle.h"
#include "assets/message.h"

namespace patina {

/// Owns one end of the local socket between the client and the files process. Messages keep their
/// boundaries; each may carry one file descriptor, that of a shared block with the bulk data.
class Channel {
  public:
    struct Delivery {
        Message message;
        FileHandle attachment; ///< is empty when nothing was attached
    };

    enum class Fault {
        closed,   ///< the other side is gone
        malformed ///< it sent something that is not a message
    };

    Channel() = default;
    explicit Channel(FileHandle socket) : socket_(std::move(socket)) {}

    /// Makes two connected ends, which are closed on exec; the handles are empty when the system
    /// has none left.
    static std::pair<FileHandle, FileHandle> pair();

    /// Returns false when the message could not be sent, as when the other side is gone.
    /// `attachment` is a descriptor, -1 for none; it stays the caller's.
    bool send(const Message& message, int attachment = -1) const;

    /// Waits for a message for at most `patience` (for ever where that is negative) and returns
    /// nothing when none came.
    tl::expected<std::optional<Delivery>, Fault> receive(std::chrono::milliseconds patience) const;

  private:
    FileHandle socket_;
};

} // namespace patina
