// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/outline_pass.h"

namespace patina {

Result<bool> OutlinePass::prepare(FramePlan&, FrameGpu&) {
    batch_ = 0;
    drawer_ = BatchDrawer();
    return false;
}

bool OutlinePass::draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) {
    for (; batch_ < plan.list.opaqueBatches(); ++batch_) {
        if (!drawer_.drawLines(plan, gpu, plan.list.batches()[batch_], budget)) {
            return false;
        }
    }
    return true;
}

} // namespace patina
