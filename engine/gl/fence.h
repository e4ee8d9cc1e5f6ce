// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <utility>

namespace patina::gl {

/// Represents a mark behind the commands given so far: tells when the device has done them.
/// Move-only; made and destroyed with its context current. An empty one is always passed.
class Fence {
  public:
    /// Also sends the commands on their way.
    static Fence afterCommandsSoFar();

    Fence() = default;
    Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
    Fence& operator=(Fence&& other) noexcept {
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Fence();

    /// Waits for at most `patience`; true when the device has come this far. A passed fence is
    /// empty.
    bool passed(std::chrono::nanoseconds patience);

    /// Has the device wait for it before it does what the current context is given from now on,
    /// one that shares objects with the fence's own.
    void holdBack() const;

  private:
    void* sync_ = nullptr; ///< a GLsync
};

} // namespace patina::gl
