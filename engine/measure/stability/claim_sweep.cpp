// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/claim_sweep.h"

#include <algorithm>
#include <cmath>

#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

/// Is the number of sets of values beside the variant's own.
constexpr std::size_t furtherRows = 4;

/// Is the number of places from which on a step takes no further trial.
constexpr std::size_t enoughPlaces = 4096;

std::vector<EvalCase> rowsOf(const EvalCase& variant) {
    std::vector<EvalCase> rows{variant};
    const auto further = ordinaryRows(variant, furtherRows);
    rows.insert(rows.end(), further.begin(), further.end());
    return rows;
}

} // namespace

ClaimSweep::ClaimSweep(const EvalCase& variant) : trials_(claimTrials(variant)) {
    if (!trials_.empty()) {
        rows_ = rowsOf(variant);
    }
}

double ClaimSweep::progress() const {
    if (rows_.empty()) {
        return 1.0;
    }
    const double within = static_cast<double>(trial_) / static_cast<double>(trials_.size());
    return (static_cast<double>(row_) + within) / static_cast<double>(rows_.size());
}

std::vector<const ClaimTrial*> ClaimSweep::nextTrials() {
    std::vector<const ClaimTrial*> next;
    for (std::size_t places = 0; trial_ < trials_.size() && places < enoughPlaces; ++trial_) {
        next.push_back(&trials_[trial_]);
        places += trials_[trial_].places.size();
    }
    return next;
}

EvalCase ClaimSweep::caseOf(const ClaimTrial& trial, std::size_t place) const {
    EvalCase request = trial.brightest ? brightest(rows_[row_]) : rows_[row_];
    static_cast<EvalPlace&>(request) = trial.places[place];
    request.gpu = true;
    return request;
}

Steps ClaimSweep::run(const EvalProgram& program, SweepReport& report, Result<void>& done) {
    for (; row_ < rows_.size(); ++row_) {
        for (trial_ = 0; trial_ < trials_.size();) {
            co_yield Steps::Pause();
            done = tryOut(nextTrials(), program, report);
            if (!done) {
                co_return;
            }
        }
    }
}

/// Draws the trials' places in one go and judges them.
Result<void> ClaimSweep::tryOut(const std::vector<const ClaimTrial*>& trials,
                                const EvalProgram& program, SweepReport& report) const {
    const auto numbers = static_cast<std::size_t>(program.shape().caseTexels) * 4;
    std::vector<float> texels;
    for (const ClaimTrial* trial : trials) {
        EvalCase request = caseOf(*trial, 0);
        const std::vector<float> values = valueTexels(request);
        for (const EvalPlace& place : trial->places) {
            static_cast<EvalPlace&>(request) = place;
            const std::vector<float> own = placeTexels(request);
            const std::size_t end = texels.size() + numbers;
            texels.insert(texels.end(), own.begin(), own.end());
            texels.insert(texels.end(), values.begin(), values.end());
            texels.resize(end);
        }
    }
    const std::size_t count = texels.size() / numbers;
    const Result<std::vector<float>> drawn = program.draw(std::move(texels), count);
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    std::size_t next = 0;
    for (const ClaimTrial* trial : trials) {
        std::vector<double> first;
        for (std::size_t i = 0; i < trial->places.size(); ++i, next += program.shape().results) {
            first.push_back(static_cast<double>((*drawn)[next]));
        }
        judge(*trial, first, report);
    }
    report.cases += count;
    return {};
}

/// Judges a trial, unless one of its values is not finite: that is found without claims.
void ClaimSweep::judge(const ClaimTrial& trial, std::span<const double> values,
                       SweepReport& report) const {
    if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); })) {
        return;
    }
    if (const auto broken = trial.judge(values)) {
        report.add({trial.defect, caseOf(trial, broken->place), ReferenceNumbers{broken->value}, 1,
                    ReferenceNumbers{broken->limit}, broken->excess});
    }
}

} // namespace patina
