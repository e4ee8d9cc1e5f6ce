// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/prewarmer.h"

#include <utility>

#include "shading/effects/environment_effect.h"

namespace patina {

Prewarmer::Prewarmer(FrameLoop& frames, const ViewedScene& viewed)
    : frames_(frames), viewed_(viewed), programs_(viewed) {
    turn_.setSingleShot(true);
    connect(&turn_, &QTimer::timeout, this, &Prewarmer::makeNext);
    connect(&frames, &FrameLoop::frameDrawn, this, &Prewarmer::goOn);
    connect(&programs_, &OrderedPrograms::came, this, &Prewarmer::prepare);
    connect(&programs_, &OrderedPrograms::givenUp, this, [this] { ahead_.clear(); });
}

/// Adds the frame of a change last, as frames are taken from the end of the list and a change is
/// shown first.
void Prewarmer::add(const Scene& ahead) {
    if (frames_.canDraw() && !frames_.isInspecting()) {
        ahead_.push_back({ahead, false});
        if (viewed_.catalog() != nullptr && fitsWhileMoving(ahead, *viewed_.catalog())) {
            ahead_.push_back({ahead, true});
        }
        programs_.forget();
        turn_.start(0);
    }
}

void Prewarmer::goOn() {
    if (isBusy()) {
        turn_.start(0);
    }
}

/// Does nothing while the view has a frame to draw, whose end calls this again.
void Prewarmer::makeNext() {
    if (!frames_.canDraw() || frames_.isInspecting()) {
        ahead_.clear();
        return;
    }
    if (ahead_.empty() || !frames_.isUpToDate()) {
        return;
    }
    if (programs_.canOrder()) {
        programs_.order(ahead_.back().scene, viewOf(ahead_.back()));
    } else {
        prepare();
    }
}

/// Loads what was made elsewhere, so that a frame that needs it does not have to.
void Prewarmer::prepare() {
    if (!frames_.canDraw() || ahead_.empty() || !frames_.isUpToDate()) {
        return;
    }
    const Ahead ahead = std::move(ahead_.back());
    ahead_.pop_back();
    frames_.drawUnseen(ahead.scene, viewOf(ahead));
    turn_.start(0);
}

/// Returns how a scene that is prewarmed will be looked at.
View Prewarmer::viewOf(const Ahead& ahead) const {
    View view = frames_.view();
    view.effects = nullptr;
    view.isMoving = ahead.isMoving;
    return view;
}

} // namespace patina
