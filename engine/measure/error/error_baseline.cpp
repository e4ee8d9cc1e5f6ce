// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/error_baseline.h"

#include <utility>

namespace patina {

ErrorBaseline::ErrorBaseline(GroundTruthFrame::Wish wish, std::string directions)
    : wish_(std::move(wish)), directions_(std::move(directions)), groundTruth_(wish_) {}

Result<bool> ErrorBaseline::step(std::chrono::milliseconds patience) {
    if (converged_) {
        return converged_->step(patience);
    }
    const Result<bool> done = groundTruth_.step(patience);
    if (done && *done && !directions_.empty()) {
        converged_.emplace(ConvergedFrame::Wish{wish_.renderer, wish_.meshes, wish_.drawn,
                                                groundTruth_.meter().groundTruth()});
    }
    return done ? Result<bool>(isDone()) : done;
}

bool ErrorBaseline::isDone() const {
    return groundTruth_.isDone() && (directions_.empty() || (converged_ && converged_->isDone()));
}

double ErrorBaseline::progressOfStep() const {
    return converged_ ? converged_->progress() : groundTruth_.progress();
}

std::optional<ConvergedRender> ErrorBaseline::converged() const {
    if (!converged_) {
        return std::nullopt;
    }
    return ConvergedRender{directions_, converged_->directions(), converged_->noise(),
                           converged_->finest()};
}

const ErrorMeter& ErrorBaseline::meterOf(const ChosenLevels& levels) const {
    return converged_ && levels.contains(directions_) ? converged_->meter() : groundTruth_.meter();
}

} // namespace patina
