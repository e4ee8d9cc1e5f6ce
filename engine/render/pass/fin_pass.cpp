// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/fin_pass.h"

namespace patina {

Result<bool> FinPass::prepare(PreparedFrame&, FrameGpu&) {
    batch_ = 0;
    drawer_ = BatchDrawer();
    return false;
}

bool FinPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    for (; batch_ < frame.list.opaqueBatches(); ++batch_) {
        if (!drawer_.drawFins(frame, gpu, frame.list.batches()[batch_], budget)) {
            return false;
        }
    }
    return true;
}

} // namespace patina
