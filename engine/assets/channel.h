// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include <tl/expected.hpp>

#include "assets/file_handle.h"
#include "assets/message.h"

namespace patina {

/// Represents one end of the local socket between the client and the files process. Messages keep
/// their boundaries; each may carry one file descriptor, the shared block with the bulk data.
class Channel {
  public:
    struct Delivery {
        Message message;
        FileHandle attachment; ///< empty when nothing was attached
    };

    enum class Fault {
        closed,   ///< the other side is gone
        malformed ///< it sent something that is not a message
    };

    Channel() = default;
    explicit Channel(FileHandle socket) : socket_(std::move(socket)) {}

    /// Two connected ends, both closed on exec; empty handles when the system has none left.
    static std::pair<FileHandle, FileHandle> pair();

    /// False when the other side is gone.
    bool send(const Message& message, int attachment = -1) const;

    /// Waits for a message for at most `patience` (negative: for ever); nothing when none came.
    tl::expected<std::optional<Delivery>, Fault> receive(std::chrono::milliseconds patience) const;

  private:
    FileHandle socket_;
};

} // namespace patina
