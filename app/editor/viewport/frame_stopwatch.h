// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>

#include "measure/time/frame_timer.h"
#include "viewport/view_context.h"

namespace patina {

/// Knows how long the frames of a view take, and how that is measured.
class FrameStopwatch {
  public:
    explicit FrameStopwatch(const ViewContext& context) : context_(context) {}

    // The views' context is current in these.
    void open() { timer_.emplace(FrameTimer::Method::WallClock); }
    void close() { timer_.reset(); }
    void begin() { timer_->begin(); }
    void end() { timer_->end(); }

    /// The time of the last frame that is known by now; 0 before there is one.
    double milliseconds() const { return timer_->milliseconds(); }

    /// "1.3 ms (GPU timer)", or how else it was measured. Call it a moment after the frame.
    QString text();

    /// Finds out how frames are best timed here, which takes some milliseconds; a clock on the
    /// wall does until then, and where a frame `isOpen`.
    void choose(bool isOpen);

  private:
    const ViewContext& context_;
    std::optional<FrameTimer> timer_; ///< while there is a context
    QString text_;                    ///< the last one that was known
};

} // namespace patina
