// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Viewport that makes programs before they are wanted.
#include <utility>

#include "viewport/viewport.h"

namespace patina {

void Viewport::foresee(const Scene& effects) {
    if (renderer_ && isVisible() && !inspecting_) {
        foreseen_.push_back(effects);
        foresight_.start(0);
    }
}

/// What is drawn goes first; the frame that comes then asks again for what is left.
void Viewport::makeForeseen() {
    if (!renderer_ || inspecting_ || foreseen_.empty()) {
        foreseen_.clear();
        return;
    }
    if (stale_ || isDrawing()) {
        return;
    }
    const Scene effects = std::move(foreseen_.back());
    foreseen_.pop_back();
    View ahead = view();
    ahead.effects = &effects;
    makeCurrent();
    renderer_->foresee(sources_.scene(), ahead, sources_.meshes);
    doneCurrent();
    watchForRest();
    foresight_.start(0);
}

} // namespace patina
