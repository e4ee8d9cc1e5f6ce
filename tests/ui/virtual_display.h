// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <sys/types.h>

namespace patina::tests {

/// An X server of our own, without a screen, that ends with this object. It chooses a free display
/// number itself, so that tests may run side by side.
class VirtualDisplay {
  public:
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    /// ":5", or empty when no server could be started.
    const std::string& name() const { return name_; }

  private:
    pid_t server_ = -1;
    std::string name_;
};

} // namespace patina::tests
