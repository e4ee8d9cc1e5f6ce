// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

namespace patina {

struct FramePlan;
struct FrameGpu;
class StepBudget;

/// Represents a part of drawing a frame. It is prepared and drawn again for every frame, and keeps
/// its memory.
class Pass {
  public:
    Pass() = default;
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;
    virtual ~Pass() = default;

    /// Prepares a frame, up to and with the first thing that takes long: true as long as there may
    /// be more, and the next call goes on. Adds to the plan what later passes need.
    virtual Result<bool> prepare(FramePlan&, FrameGpu&) { return false; }

    /// Draws what was prepared. False where it is time to stop: the next call goes on there, and
    /// one after the last does nothing.
    virtual bool draw(const FramePlan&, FrameGpu&, StepBudget&) { return true; }

    /// The shader files may have changed.
    virtual void forget() {}
};

} // namespace patina
