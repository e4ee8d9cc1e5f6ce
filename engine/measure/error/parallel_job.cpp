// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/parallel_job.h"

#include <algorithm>
#include <utility>

#include "measure/error/parallel.h"

namespace patina {
namespace {

/// Is how many elements are done at once: some milliseconds of work on pixels, beside which
/// starting threads costs little.
constexpr std::size_t placesAtOnce = 16384;

} // namespace

void ParallelJob::add(std::size_t places, Stage stage) {
    if (places > 0) {
        stages_.push_back({places, std::move(stage), {}});
    }
}

void ParallelJob::addOnce(std::function<void()> work) {
    stages_.push_back({0, {}, std::move(work)});
}

bool ParallelJob::step(std::chrono::milliseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!isDone()) {
        doPiece();
        if (std::chrono::steady_clock::now() >= deadline) {
            break;
        }
    }
    return isDone();
}

void ParallelJob::finish() {
    while (!isDone()) {
        doPiece();
    }
}

void ParallelJob::doPiece() {
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
