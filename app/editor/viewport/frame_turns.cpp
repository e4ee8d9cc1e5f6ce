// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/frame_turns.h"

#include <algorithm>
#include <utility>

namespace patina {

FrameTurns::FrameTurns() {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &FrameTurns::giveNext);
}

void FrameTurns::giveNext() {
    if (!queue_.empty()) {
        timer_.start(0); // before the work, which may end the last place
        queue_.front()->work_();
    }
}

FrameTurns::Place::Place(FrameTurns& turns, std::function<void()> work)
    : turns_(turns), work_(std::move(work)) {}

FrameTurns::Place::~Place() {
    leave();
}

void FrameTurns::Place::take(Urgency urgency) {
    leave();
    urgency_ = urgency;
    const auto behind = std::ranges::upper_bound(turns_.queue_, urgency, {}, &Place::urgency_);
    turns_.queue_.insert(behind, this);
    turns_.timer_.start(0);
}

void FrameTurns::Place::leave() {
    std::erase(turns_.queue_, this);
}

} // namespace patina
