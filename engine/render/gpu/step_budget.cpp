// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/step_budget.h"

namespace patina {

void StepBudget::beginFrame() {
    fence_ = gl::Fence();
}

bool StepBudget::beginStep(Deadline deadline) {
    deadline_ = deadline;
    if (!deviceIsDone()) {
        return false;
    }
    pace_.passed(Clock::now()); // what the last step did not wait for
    return true;
}

void StepBudget::addTriangles(std::int64_t triangles) {
    if (!isEndless()) {
        pace_.add(triangles, Clock::now());
    }
}

bool StepBudget::mustStop() {
    if (isSoftware_ && !isEndless()) {
        mark();
    }
    if (!deviceIsDone()) {
        return true;
    }
    pace_.passed(Clock::now());
    return isOver();
}

void StepBudget::mark() {
    fence_ = gl::Fence::afterCommandsSoFar();
}

} // namespace patina
