// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <utility>

namespace patina::gl {

/// Tells when the device has done the commands that were given before it. It can only be moved, and
/// must be made and destroyed with its context current. An empty one has always passed.
class Fence {
  public:
    /// Makes a fence after the commands given so far and flushes them, so that the device begins.
    static Fence afterCommandsSoFar();

    Fence() = default;
    Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
    Fence& operator=(Fence&& other) noexcept {
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Fence();

    /// Waits for at most `patience` and returns true when the device has come this far or when
    /// waiting failed. The fence is empty after that.
    bool passed(std::chrono::nanoseconds patience);

    /// Makes the device wait for this fence before it runs later commands of the current context,
    /// which must share objects with the fence's context.
    void holdBack() const;

  private:
    void* sync_ = nullptr; ///< is a GLsync; null when empty
};

} // namespace patina::gl
