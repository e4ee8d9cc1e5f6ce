// SPDX-License-Identifier: GPL-3.0-or-later
// How a view goes on with an environment's light while nothing changes, and then stops.
#include "render/frame/frame_job.h"
#include "scene/environment.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

/// What is between two frames, for the rest of the window.
constexpr int pauseMs = 5;

} // namespace

int Viewport::samples() const {
    return renderer_ ? renderer_->job().environmentSamples() : 0;
}

int Viewport::wantedSamples() const {
    const BlockValues* environment = sources_.scene().part(kinds::environment);
    const Block* block = catalog_ == nullptr
                             ? nullptr
                             : blockOf(sources_.scene().parts, kinds::environment, *catalog_);
    return block == nullptr ? usualDirections : directionsOf(*environment, *block);
}

bool Viewport::wantsSamples() const {
    return samples() > 0 && samples() < wantedSamples() && !inspecting_;
}

/// After a frame that shows the scene as it is.
void Viewport::continueSoon() {
    if (wantsSamples() && !sampleTimer_.isActive()) {
        sampleTimer_.start(pauseMs);
    }
}

void Viewport::addSamples() {
    if (wantsSamples() && !stale_ && !isDrawing()) {
        moreSamples_ = true;
        update();
    }
}

} // namespace patina
