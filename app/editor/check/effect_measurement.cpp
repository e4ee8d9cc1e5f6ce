// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/effect_measurement.h"

#include <utility>

#include "gl/headless_context.h"

namespace patina {

EffectMeasurement::EffectMeasurement(std::filesystem::path programCache, QObject* parent)
    : QObject(parent), programCache_(std::move(programCache)) {
    worker_.setMaxThreadCount(1);
    worker_.setExpiryTimeout(100);
}

EffectMeasurement::~EffectMeasurement() {
    cancelled_ = true;
    worker_.waitForDone();
}

void EffectMeasurement::start(EffectCostMeter::Subject subject) {
    if (std::exchange(running_, true)) {
        return;
    }
    cancelled_ = false;
    worker_.start([this, subject = std::move(subject)] {
        const Outcome outcome = measure(subject);
        QMetaObject::invokeMethod(this, [this, outcome] {
            running_ = false;
            Q_EMIT finished(outcome);
        });
    });
}

void EffectMeasurement::cancel() {
    cancelled_ = true;
}

/// In the worker's thread.
EffectMeasurement::Outcome EffectMeasurement::measure(EffectCostMeter::Subject subject) {
    Outcome outcome;
    const auto context = gl::HeadlessContext::create();
    EffectCostMeter::Options options;
    options.programCache = programCache_;
    options.mayShrink = true;
    auto meter = context ? EffectCostMeter::create(std::move(subject), options)
                         : tl::unexpected(context.error());
    if (!meter) {
        outcome.problem = QString::fromStdString(meter.error().text());
        return outcome;
    }
    while (!(*meter)->finished() && !cancelled_) {
        (*meter)->step();
        Q_EMIT progressed((*meter)->progress());
    }
    outcome.costs = (*meter)->costs();
    outcome.complete = (*meter)->finished();
    outcome.problem = QString::fromStdString(text(outcome.costs.problems)).trimmed();
    return outcome;
}

} // namespace patina
