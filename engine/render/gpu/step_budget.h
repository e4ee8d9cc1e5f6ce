// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>

#include "gl/fence.h"
#include "render/gpu/triangle_budget.h"

namespace patina {

/// Decides when a step of a frame must end, and knows whether the device has finished the work of
/// the steps so far.
class StepBudget {
  public:
    using Clock = std::chrono::steady_clock;
    using Deadline = Clock::time_point;
    static constexpr Deadline never = Deadline::max();

    /// Starts without a deadline. `isSoftware` says that the device is the CPU itself.
    explicit StepBudget(bool isSoftware = false) : isSoftware_(isSoftware) {}

    /// Begins a frame; it does not wait for what the device still draws of the last one.
    void beginFrame();

    /// Begins to draw a frame, see TriangleBudget::begin().
    void beginDrawing(bool hasManyTriangles) { pace_.begin(hasManyTriangles); }

    /// Begins a step. Returns false when the device has not finished the last step by the deadline.
    bool beginStep(Deadline deadline);

    /// Returns true when the step has no deadline and draws the whole rest.
    bool isEndless() const { return deadline_ == never; }
    bool isOver() const { return Clock::now() >= deadline_; }

    /// Returns how many triangles may be drawn before isDue() is called.
    std::int64_t maxTriangles() const {
        return isEndless() ? std::numeric_limits<std::int64_t>::max() : pace_.maxTriangles();
    }
    void addTriangles(std::int64_t triangles);

    /// Returns true when enough was drawn to ask the clock, and the step must stop.
    bool isDue() { return !isEndless() && pace_.isDue() && mustStop(); }

    /// Returns true when the step must stop: the deadline is over, or the device is still busy. A
    /// software driver works in the background and delays what the window draws, so it gets the
    /// next slice only when it has finished the last one.
    bool mustStop();

    /// Makes deviceIsDone() wait for all commands given so far.
    void mark();
    bool deviceIsDone() { return fence_.passed(deadline_ - Clock::now()); }

  private:
    bool isSoftware_;
    Deadline deadline_ = never;
    TriangleBudget pace_;
    gl::Fence fence_; ///< is passed when the device has done the commands before the last mark()
};

} // namespace patina
