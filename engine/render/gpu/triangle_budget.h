// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

namespace patina {

/// Decides how many triangles a step of a frame draws at once, so that they take about 15 ms.
class TriangleBudget {
  public:
    using Clock = std::chrono::steady_clock;

    /// Begins a frame. One with many triangles (`isLarge`) has small ones and begins with many at
    /// once; another one begins with a single triangle, whose pixels may take long.
    void begin(bool isLarge) {
        maxTriangles_ = isLarge ? maxAtOnce : 1;
        drawn_ = 0;
        began_.reset();
    }

    std::int64_t maxTriangles() const { return maxTriangles_; }

    void add(std::int64_t triangles, Clock::time_point now) {
        began_ = began_.value_or(now);
        drawn_ += triangles;
    }

    /// Returns true when enough was drawn to ask the clock.
    bool isDue() const { return drawn_ >= maxTriangles_; }

    /// Notes that the device has finished the triangles that were added, and fits maxTriangles() to
    /// the time.
    void passed(Clock::time_point now) {
        if (!began_) {
            return;
        }
        const std::chrono::duration<double, std::milli> taken = now - *began_;
        const double change = std::clamp(sliceMs / std::max(taken.count(), 1e-3), 0.0, maxGrowth);
        maxTriangles_ =
            std::clamp(static_cast<std::int64_t>(change * static_cast<double>(maxTriangles_)),
                       std::int64_t(1), maxAtOnce);
        drawn_ = 0;
        began_.reset();
    }

  private:
    static constexpr std::int64_t maxAtOnce = 16384;
    static constexpr double sliceMs = 15.0;
    static constexpr double maxGrowth = 4.0; ///< limits the growth from slice to slice, since the
                                             ///< next triangles may be larger

    std::int64_t maxTriangles_ = 1;
    std::int64_t drawn_ = 0; ///< counts since passed()
    std::optional<Clock::time_point> began_;
};

} // namespace patina
