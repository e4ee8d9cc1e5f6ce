// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <string_view>

#include "gl/query.h"

namespace patina {

/// Times frames in the current context. At the start it times known work by both methods and keeps
/// the device's own timer only where that agrees with the wall clock: software renderers and some
/// drivers report times that mean nothing.
class FrameTimer {
  public:
    enum class Method {
        DeviceTimer, ///< reads timestamps of the device when they are ready: costs nothing
        WallClock,   ///< reads a clock around glFinish: waits for the device
    };

    /// Finds out which method works, which takes some milliseconds.
    FrameTimer();

    /// Uses a method that is already known.
    explicit FrameTimer(Method method);

    void begin();
    void end();

    /// Reads the times that have become known, without waiting.
    void collect();

    /// Returns the milliseconds of the newest frame whose time is known; 0 before the first.
    double milliseconds() const { return milliseconds_; }

    Method method() const { return method_; }

    /// Returns the method as users read it: "GPU timer" or "clock around glFinish".
    std::string_view methodText() const;

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t inFlight = 4;

    struct Running {
        gl::TimeQuery query = gl::TimeQuery::create();
        bool started = false;
    };

    Method method_;
    std::array<Running, inFlight> queries_;
    std::size_t next_ = 0;
    bool measuring_ = false;
    Clock::time_point start_;
    double milliseconds_ = 0.0;
};

/// Tells whether the device's timer can be trusted in the current context.
FrameTimer::Method trustedMethod();

} // namespace patina
