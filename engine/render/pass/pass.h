// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/error.h"

namespace patina {

struct PreparedFrame;
struct FrameGpu;
class StepBudget;

/// Draws a part of a frame. A pass is prepared and drawn again for each frame and keeps its memory.
class Pass {
  public:
    Pass() = default;
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;
    virtual ~Pass() = default;

    /// Prepares a frame in steps, each up to the first long step of work. Returns true while there
    /// may be more to do; then it must be called again. It adds what later passes need.
    virtual Result<bool> prepare(PreparedFrame&, FrameGpu&) { return false; }

    /// Draws what was prepared. Returns false when the budget is used up; the next call continues.
    /// A call after the last does nothing.
    virtual bool draw(const PreparedFrame&, FrameGpu&, StepBudget&) { return true; }

    /// Returns what it draws, in words for users; passes that draw one thing have the same. Empty
    /// where it only prepares.
    virtual std::string_view name() const { return {}; }

    /// Drops what was made from shader files, because they may have changed.
    virtual void forget() {}
};

} // namespace patina
