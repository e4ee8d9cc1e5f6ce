// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/piece_work.h"

#include <algorithm>
#include <utility>

#include "measure/parallel.h"

namespace patina {
namespace {

/// Some milliseconds of what is done to pixels; threads cost much less than that.
constexpr std::size_t placesAtOnce = 16384;

} // namespace

void PieceWork::add(std::size_t places, Stage stage) {
    if (places > 0) {
        stages_.push_back({places, std::move(stage), {}});
    }
}

void PieceWork::addOnce(std::function<void()> work) {
    stages_.push_back({0, {}, std::move(work)});
}

bool PieceWork::step(std::chrono::milliseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!isDone()) {
        doPiece();
        if (std::chrono::steady_clock::now() >= deadline) {
            break;
        }
    }
    return isDone();
}

void PieceWork::finish() {
    while (!isDone()) {
        doPiece();
    }
}

void PieceWork::doPiece() {
    const Planned& stage = stages_.front();
    if (!stage.work) {
        stage.once();
    } else {
        const std::size_t first = done_;
        done_ = std::min(first + placesAtOnce, stage.places);
        inParallel(done_ - first, [&stage, first](std::size_t, std::size_t begin, std::size_t end) {
            stage.work(first + begin, first + end);
        });
    }
    if (done_ >= stage.places) {
        done_ = 0;
        stages_.pop_front();
    }
}

} // namespace patina
