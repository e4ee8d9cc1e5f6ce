// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace patina::gl {

/// Collects what the driver has to say about how it is used, while it exists. One per context.
class DebugOutput {
  public:
    /// Starts listening in the current context, synchronously. Notifications are left
    /// out, and so is what a shader's log says.
    DebugOutput();
    ~DebugOutput();
    DebugOutput(const DebugOutput&) = delete;
    DebugOutput& operator=(const DebugOutput&) = delete;

    /// False when the driver cannot report anything.
    bool available() const { return available_; }

    const std::vector<std::string>& messages() const { return messages_; }

  private:
    bool available_ = false;
    std::vector<std::string> messages_;
};

} // namespace patina::gl
