// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/error_baseline.h"

#include <utility>

#include "measure/choice/pass_choices.h"

namespace patina {

ErrorBaseline::ErrorBaseline(GroundTruthFrame::Wish wish, std::string directions, bool hasPasses)
    : wish_(std::move(wish)), directions_(std::move(directions)), groundTruth_(wish_) {
    if (hasPasses) {
        GroundTruthFrame::Wish finished = wish_;
        finished.drawn.isFinished = true;
        finished.inDoubles = false; // passes have no code in double precision
        finished_.emplace(std::move(finished));
    }
}

Result<bool> ErrorBaseline::step(std::chrono::milliseconds patience) {
    if (converged_) {
        return converged_->step(patience);
    }
    GroundTruthFrame& current = finished_ && groundTruth_.isDone() ? *finished_ : groundTruth_;
    const Result<bool> done = current.step(patience);
    if (done && hasGroundTruth() && !directions_.empty()) {
        converged_.emplace(ConvergedFrame::Wish{wish_.renderer, wish_.meshes, wish_.drawn,
                                                groundTruth_.meter().groundTruth()});
    }
    return done ? Result<bool>(isDone()) : done;
}

bool ErrorBaseline::hasGroundTruth() const {
    return groundTruth_.isDone() && (!finished_ || finished_->isDone());
}

bool ErrorBaseline::isDone() const {
    return hasGroundTruth() && (directions_.empty() || (converged_ && converged_->isDone()));
}

double ErrorBaseline::progressOfStep() const {
    const double drawn = finished_ ? 0.5 * (groundTruth_.progress() + finished_->progress())
                                   : groundTruth_.progress();
    return converged_ ? converged_->progress() : drawn;
}

std::optional<ConvergedRender> ErrorBaseline::converged() const {
    if (!converged_) {
        return std::nullopt;
    }
    return ConvergedRender{directions_, converged_->directions(), converged_->noise(),
                           converged_->finest()};
}

const ErrorMeter& ErrorBaseline::meterOf(const ChosenLevels& levels) const {
    if (finished_ && hasPassLevel(levels)) {
        return finished_->meter();
    }
    return converged_ && levels.contains(directions_) ? converged_->meter() : groundTruth_.meter();
}

} // namespace patina
