// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/stability_check.h"

#include <utility>

#include "measure/stability/finding_text.h"
#include "measure/stability/stability_sweep.h"
#include "measure/stability/sweep_cases.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

/// Is about the number of cases that a check evaluates.
constexpr std::size_t checkedCases = 300000;

/// Is the number of cases between two checks for cancellation.
constexpr std::size_t checkSlice = std::size_t(1) << 12;

StabilityFailure failureOf(const SweepKey& key, const SweepTally& tally) {
    const EvalCase& request = tally.worst.request;
    const QString programs = asText(variantText(request));
    const QString place = asText(placeText(request));
    return {QStringLiteral("%1 %2").arg(wordsFor(key.defect), precisionText(key.gpu)),
            programs.isEmpty() ? place : QStringLiteral("%1; %2").arg(place, programs),
            asText(amountText(tally.worst)), asText(evalJson(request).dump()), tally.count};
}

StabilityOutcome outcomeOf(const StabilitySweep& sweep) {
    StabilityOutcome outcome;
    outcome.complete = sweep.finished();
    outcome.cases = sweep.report().cases;
    outcome.limit = limitText(sweep.report());
    for (const auto& [key, tally] : sweep.report().defects) {
        outcome.failures.push_back(failureOf(key, tally));
    }
    for (const Error& error : sweep.report().errors) {
        outcome.problems << asText(error.text());
    }
    if (!sweep.withoutReference().empty()) {
        outcome.remarks
            << QObject::tr("Not in double precision: %1").arg(asText(sweep.withoutReference()));
    }
    return outcome;
}

/// Returns the cases to sweep: the material's model with the blocks in its slots, and its Fresnel
/// term where that is blended.
Result<std::vector<EvalCase>> variantsOf(const Catalog& catalog, const Material& material) {
    Result<EvalCase> own = sweepVariant(catalog, material);
    if (!own) {
        return tl::unexpected(own.error());
    }
    std::vector<EvalCase> variants{std::move(*own)};
    const std::vector<EvalCase> blend = blendVariants(catalog, material);
    variants.insert(variants.end(), blend.begin(), blend.end());
    return variants;
}

} // namespace

StabilityOutcome checkStability(const Catalog& catalog, const Material& material,
                                Worker::Control& control) {
    Result<std::vector<EvalCase>> variants = variantsOf(catalog, material);
    if (!variants) {
        StabilityOutcome outcome;
        outcome.problems << asText(variants.error().text());
        return outcome;
    }
    const Result<void> context = control.openContext();
    SweepOptions options;
    options.gpu = context.has_value();
    options.cases = checkedCases;
    options.slice = checkSlice;
    options.shaders = catalog.roots.front().folder;
    StabilitySweep sweep(std::move(*variants), options);
    while (!sweep.finished() && !control.isCancelled()) {
        sweep.step();
        control.report(sweep.progress(),
                       QObject::tr("%1 cases").arg(wholeText(sweep.report().cases)));
    }
    StabilityOutcome outcome = outcomeOf(sweep);
    if (!context) {
        outcome.remarks
            << QObject::tr("Not on the graphics device: %1").arg(asText(context.error().text()));
    }
    return outcome;
}

} // namespace patina
