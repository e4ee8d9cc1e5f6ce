// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>

#include "gl/fence.h"
#include "render/gpu/slice_pace.h"

namespace patina {

/// Counts how long a step of a frame may take, and how far the device is with what the steps so far
/// have given it.
class StepBudget {
  public:
    using Clock = std::chrono::steady_clock;
    using Deadline = Clock::time_point;
    static constexpr Deadline never = Deadline::max();

    /// Has no end until a step begins with one. `isSoftware`: the device is the CPU itself.
    explicit StepBudget(bool isSoftware = false) : isSoftware_(isSoftware) {}

    /// Begins a frame, which nothing of the last one is waited for.
    void beginFrame();

    /// Begins to draw a frame. Triangles of one that has many are small; of others the pixels may
    /// take long.
    void beginDrawing(bool hasManyTriangles) { pace_.begin(hasManyTriangles); }

    /// Begins a step. False where the device is at the last one's work beyond the deadline.
    bool beginStep(Deadline deadline);

    /// Tells whether the step draws all there is.
    bool isEndless() const { return deadline_ == never; }
    bool isOver() const { return Clock::now() >= deadline_; }

    /// The most triangles to draw before the clock is asked.
    std::int64_t maxTriangles() const {
        return isEndless() ? std::numeric_limits<std::int64_t>::max() : pace_.maxTriangles();
    }
    void addTriangles(std::int64_t triangles);

    /// Tells whether so much was drawn that it is time to look at the clock, and that says so.
    bool isDue() { return !isEndless() && pace_.isDue() && mustStop(); }

    /// Asks the clock. A device that is the CPU works in the background, and what the window
    /// draws has to wait behind that: it gets the next slice when it has done the last one.
    bool mustStop();

    /// What was given to the device so far is what deviceIsDone() waits for.
    void mark();
    bool deviceIsDone() { return fence_.passed(deadline_ - Clock::now()); }

  private:
    bool isSoftware_;
    Deadline deadline_ = never;
    SlicePace pace_;
    gl::Fence fence_; ///< behind the last commands of a frame that is drawn in steps
};

} // namespace patina
