// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/prewarmer.h"

#include <utility>

namespace patina {

Prewarmer::Prewarmer(FrameLoop& frames, const ViewedScene& viewed)
    : frames_(frames), programs_(viewed) {
    turn_.setSingleShot(true);
    connect(&turn_, &QTimer::timeout, this, &Prewarmer::makeNext);
    connect(&frames, &FrameLoop::frameDrawn, this, &Prewarmer::goOn);
    connect(&programs_, &OrderedPrograms::came, this, &Prewarmer::prepare);
}

void Prewarmer::add(const Scene& ahead) {
    if (frames_.canDraw() && !frames_.isInspecting()) {
        scenes_.push_back(ahead);
        programs_.forget();
        turn_.start(0);
    }
}

void Prewarmer::goOn() {
    if (isBusy()) {
        turn_.start(0);
    }
}

/// What is drawn goes first; the frame that comes then asks again for what is left.
void Prewarmer::makeNext() {
    if (!frames_.canDraw() || frames_.isInspecting()) {
        scenes_.clear();
        return;
    }
    if (scenes_.empty() || !frames_.isUpToDate()) {
        return;
    }
    if (programs_.canOrder()) {
        programs_.order(scenes_.back(), viewAhead());
    } else {
        prepare();
    }
}

/// Loads what was made elsewhere, so that a frame that needs it does not have to.
void Prewarmer::prepare() {
    if (!frames_.canDraw() || scenes_.empty() || !frames_.isUpToDate()) {
        return;
    }
    const Scene ahead = std::move(scenes_.back());
    scenes_.pop_back();
    frames_.drawUnseen(ahead, viewAhead());
    turn_.start(0);
}

/// How a scene that is prewarmed will be looked at.
View Prewarmer::viewAhead() const {
    View ahead = frames_.view();
    ahead.effects = nullptr;
    return ahead;
}

} // namespace patina
