// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <sys/types.h>

namespace patina::tests {

/// Runs an X server of our own, without a screen, until this object is destroyed. The server
/// chooses a free display number itself, so that tests may run side by side.
class VirtualDisplay {
  public:
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    /// Returns ":5" or the like, or an empty text when no server could be started.
    const std::string& name() const { return name_; }

  private:
    pid_t server_ = -1;
    std::string name_;
};

} // namespace patina::tests
