// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace patina::gl {

/// Collects the driver's debug messages while it exists. A context can have one at a time.
class DebugOutput {
  public:
    /// Starts listening in the current context, synchronously. Notifications and messages of the
    /// shader compiler are left out; the latter are in the shader's log.
    DebugOutput();
    ~DebugOutput();
    DebugOutput(const DebugOutput&) = delete;
    DebugOutput& operator=(const DebugOutput&) = delete;

    /// Returns false when the driver has no debug output (OpenGL 4.3 or GL_KHR_debug).
    bool available() const { return available_; }

    const std::vector<std::string>& messages() const { return messages_; }

  private:
    bool available_ = false;
    std::vector<std::string> messages_;
};

} // namespace patina::gl
