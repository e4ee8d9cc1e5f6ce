// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>

#include "measure/time/frame_timer.h"
#include "viewport/view_context.h"

namespace patina {

/// Measures how long the frames of a view take, and says how it does so.
class FrameStopwatch {
  public:
    explicit FrameStopwatch(const ViewContext& context) : context_(context) {}

    // The views' context has to be current in these.
    void open() { timer_.emplace(FrameTimer::Method::WallClock); }
    void close() { timer_.reset(); }
    void begin() { timer_->begin(); }
    void end() { timer_->end(); }

    /// Returns the milliseconds of the last frame whose time is known; 0 before there is one.
    /// open() has to come before.
    double milliseconds() const { return timer_->milliseconds(); }

    /// Returns the last time and the method, as in "1.3 ms (GPU timer)"; empty before the first.
    /// The time is known a moment after the frame.
    QString text();

    /// Chooses the most exact method that works here, which takes some milliseconds. Until then,
    /// and where a frame `isOpen`, the clock of the CPU is used.
    void choose(bool isOpen);

  private:
    const ViewContext& context_;
    std::optional<FrameTimer> timer_; ///< exists from open() to close()
    QString text_;                    ///< holds the last text while no newer time is known
};

} // namespace patina
