// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/cost_measurement.h"

#include <chrono>
#include <utility>

#include "gl/headless_context.h"

namespace patina {
namespace {

/// Work between two looks at whether it was cancelled, each of which may show new points.
constexpr std::chrono::milliseconds slice{100};

} // namespace

CostMeasurement::CostMeasurement(QObject* parent) : QObject(parent) {
    worker_.setMaxThreadCount(1);
    worker_.setExpiryTimeout(100);
}

CostMeasurement::~CostMeasurement() {
    cancelled_ = true;
    worker_.waitForDone();
}

void CostMeasurement::start(CostSweep::Subject subject, CostSweep::Options options) {
    if (std::exchange(running_, true)) {
        return;
    }
    cancelled_ = false;
    worker_.start([this, subject = std::move(subject), options = std::move(options)] {
        const Outcome outcome = measure(subject, options);
        QMetaObject::invokeMethod(this, [this, outcome] {
            running_ = false;
            Q_EMIT finished(outcome);
        });
    });
}

void CostMeasurement::cancel() {
    cancelled_ = true;
}

/// In the worker's thread, as what follows.
CostMeasurement::Outcome CostMeasurement::measure(CostSweep::Subject subject,
                                                  const CostSweep::Options& options) {
    Outcome outcome;
    told_ = 0;
    const auto context = gl::HeadlessContext::create();
    auto sweep = context ? CostSweep::create(std::move(subject), options)
                         : tl::unexpected(context.error());
    if (!sweep) {
        outcome.problem = QString::fromStdString(sweep.error().text());
        return outcome;
    }
    while (!(*sweep)->finished() && !cancelled_) {
        (*sweep)->step(slice);
        tell(**sweep);
    }
    outcome.chart = (*sweep)->chart();
    outcome.complete = (*sweep)->finished() && (*sweep)->problems().empty();
    outcome.problem = QString::fromStdString(text((*sweep)->problems())).trimmed();
    return outcome;
}

void CostMeasurement::tell(const CostSweep& sweep) {
    QMetaObject::invokeMethod(this, [this, step = sweep.doing()] { Q_EMIT progressed(step); });
    if (sweep.chart().points.size() > told_) {
        told_ = sweep.chart().points.size();
        QMetaObject::invokeMethod(this,
                                  [this, chart = sweep.chart()] { Q_EMIT charted(chart); });
    }
}

} // namespace patina
