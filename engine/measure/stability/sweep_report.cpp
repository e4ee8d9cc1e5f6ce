// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/sweep_report.h"

#include <algorithm>

namespace patina {
namespace {

void addTally(SweepTally& tally, std::size_t count, const SweepFinding& finding) {
    if (tally.count == 0 || finding.excess > tally.worst.excess) {
        tally.worst = finding;
    }
    tally.count += count;
}

} // namespace

const char* wordsFor(Defect defect) {
    switch (defect) {
    case Defect::NotANumber:
        return "not a number";
    case Defect::Infinite:
        return "infinite";
    case Defect::Negative:
        return "negative";
    case Defect::BelowHorizon:
        return "light from below the horizon";
    case Defect::NotReciprocal:
        return "claim broken: reciprocal";
    case Defect::NotIsotropic:
        return "claim broken: isotropic";
    case Defect::NotConserving:
        return "claim broken: energy_conserving";
    case Defect::NotContinuous:
        return "claim broken: continuous_at_horizon";
    case Defect::NotMonotonic:
        return "claim broken: monotonic";
    default:
        return "further from the exact value than rounding explains";
    }
}

void SweepReport::add(const SweepFinding& finding) {
    const SweepKey key{finding.request.gpu, finding.defect, calledFunction(finding.request).suffix};
    addTally(defects[key], 1, finding);
}

void SweepReport::add(const SweepReport& other) {
    cases += other.cases;
    programs += other.programs;
    largestError = std::max(largestError, other.largestError);
    for (const auto& [key, tally] : other.defects) {
        addTally(defects[key], tally.count, tally.worst);
    }
    withoutDouble = withoutDouble || other.withoutDouble;
    withoutDevice = withoutDevice || other.withoutDevice;
    errors.insert(errors.end(), other.errors.begin(), other.errors.end());
}

} // namespace patina
