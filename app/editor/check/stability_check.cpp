// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/stability_check.h"

#include <utility>

#include <QElapsedTimer>

#include "gl/headless_context.h"
#include "measure/finding_text.h"
#include "measure/stability_sweep.h"
#include "measure/sweep_cases.h"

namespace patina {
namespace {

constexpr qint64 reportEveryMs = 50;

/// Cases between two looks at whether it was cancelled.
constexpr std::size_t checkSlice = std::size_t(1) << 12;

QString asText(const std::string& text) {
    return QString::fromStdString(text);
}

StabilityFailure failureOf(const SweepTally& tally, bool gpu, Defect defect) {
    const EvalCase& request = tally.worst.request;
    const QString programs = asText(variantText(request));
    const QString place = asText(placeText(request));
    return {QStringLiteral("%1 %2").arg(wordsFor(defect), precisionText(gpu)),
            programs.isEmpty() ? place : QStringLiteral("%1; %2").arg(place, programs),
            asText(amountText(tally.worst)), asText(evalJson(request).dump()), tally.count};
}

StabilityOutcome outcomeOf(const StabilitySweep& sweep) {
    StabilityOutcome outcome;
    outcome.complete = sweep.finished();
    outcome.cases = sweep.report().cases;
    outcome.limit = limitText(sweep.report());
    for (const auto& [key, tally] : sweep.report().defects) {
        outcome.failures.push_back(failureOf(tally, key.first, key.second));
    }
    for (const Error& error : sweep.report().errors) {
        outcome.problems << asText(error.text());
    }
    if (!sweep.withoutReference().empty()) {
        outcome.remarks << StabilityCheck::tr("Not in double precision: %1")
                               .arg(asText(sweep.withoutReference()));
    }
    return outcome;
}

/// The material's model with what fills its slots, and its Fresnel term where that is blended.
Result<std::vector<EvalCase>> variantsOf(const Catalog& catalog, const Material& material) {
    Result<EvalCase> own = sweepVariant(catalog, material);
    if (!own) {
        return tl::unexpected(own.error());
    }
    std::vector<EvalCase> variants{std::move(*own)};
    if (const auto blend = blendVariant(catalog, material)) {
        variants.push_back(*blend);
    }
    return variants;
}

} // namespace

StabilityCheck::StabilityCheck(QObject* parent) : QObject(parent) {
    worker_.setMaxThreadCount(1);
    worker_.setExpiryTimeout(100);
}

StabilityCheck::~StabilityCheck() {
    cancelled_ = true;
    worker_.waitForDone();
}

void StabilityCheck::start(std::shared_ptr<const Catalog> catalog, const Material& material) {
    if (std::exchange(running_, true)) {
        return;
    }
    cancelled_ = false;
    worker_.start([this, catalog = std::move(catalog), material] {
        const StabilityOutcome outcome = check(*catalog, material);
        QMetaObject::invokeMethod(this, [this, outcome] {
            running_ = false;
            Q_EMIT finished(outcome);
        });
    });
}

void StabilityCheck::cancel() {
    cancelled_ = true;
}

StabilityOutcome StabilityCheck::check(const Catalog& catalog, const Material& material) {
    Result<std::vector<EvalCase>> variants = variantsOf(catalog, material);
    if (!variants) {
        StabilityOutcome outcome;
        outcome.problems << asText(variants.error().text());
        return outcome;
    }
    const auto context = gl::HeadlessContext::create();
    SweepOptions options;
    options.gpu = context.has_value();
    options.cases = cases;
    options.slice = checkSlice;
    options.shaders = catalog.roots.front().folder;
    StabilitySweep sweep(std::move(*variants), options);
    QElapsedTimer sinceReport;
    sinceReport.start();
    while (!sweep.finished() && !cancelled_) {
        sweep.step();
        if (sinceReport.elapsed() >= reportEveryMs) {
            sinceReport.start();
            Q_EMIT progressed(sweep.progress(), sweep.report().cases);
        }
    }
    StabilityOutcome outcome = outcomeOf(sweep);
    if (!context) {
        outcome.remarks << tr("Not on the graphics device: %1").arg(asText(context.error().text()));
    }
    return outcome;
}

} // namespace patina
