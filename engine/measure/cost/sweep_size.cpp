// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/sweep_size.h"

#include "gl/driver.h"
#include "shading/effects/environment_effect.h"

namespace patina {
namespace {

constexpr glm::ivec2 sizeOnCpu{256, 256};
constexpr glm::ivec2 sizeOnDevice{1024, 1024};

/// Is for pictures with thousands of directions per pixel.
constexpr glm::ivec2 sampledSizeOnCpu{64, 64};

} // namespace

glm::ivec2 sweepSize(const CostSweep::Subject& subject, const CostSweep::Options& options) {
    if (options.size.x > 0 && options.size.y > 0) {
        return options.size;
    }
    const bool isSampled = options.scope == Choice::Scope::Picture &&
                           environmentChoice(subject.scene, *subject.catalog).block != nullptr;
    return !gl::isSoftware() ? sizeOnDevice : isSampled ? sampledSizeOnCpu : sizeOnCpu;
}

} // namespace patina
