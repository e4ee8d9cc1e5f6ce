// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/effect_measurement.h"

#include <utility>

#include "session/session.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

/// Runs in the worker's thread.
Result<PredictedEffects> predictedFor(const EffectCostMeter::Subject& subject,
                                      const Worker::Control& control, std::size_t object) {
    std::vector<const GpuFamily*> families;
    for (const GpuFamily& family : gpuFamilies()) {
        families.push_back(&family);
    }
    FamilyCompilerOptions options;
    options.isStopped = [&control] { return control.isCancelled(); };
    return predictedEffects({subject.scene, object, subject.meshes, subject.catalog}, subject.rows,
                            families, options)
        .map_error([](const Errors& errors) { return errors.front(); });
}

} // namespace

EffectMeasurement::EffectMeasurement(const Document& document, QObject* parent)
    : QObject(parent), document_(document),
      worker_({.name = tr("Measuring effects"), .canCancel = true}) {
    connect(&worker_, &Worker::progressed, this, &EffectMeasurement::progressed);
}

void EffectMeasurement::start(const EffectCostMeter::Subject& subject,
                              EffectCostMeter::Options options) {
    if (isRunning()) {
        return;
    }
    options.programCache = programFolder();
    options.mayShrink = true;
    const Side side = document_.selection().side();
    measured_ = Measured{subject.scene, document_.selection().object(), side,
                         KnownBlocks(document_.sharedCatalog(), subject.scene)};
    const auto object = static_cast<std::size_t>(document_.selection().object());
    worker_.ask([this, subject, options = std::move(options), object](
                    Worker::Control& control) { return meter(subject, options, object, control); },
                [this](const MeasureEnd& end) {
                    if (measured_) {
                        measured_->end = end;
                    }
                    Q_EMIT ended();
                });
}

/// Runs in the worker's thread.
MeasureEnd EffectMeasurement::meter(const EffectCostMeter::Subject& subject,
                                    const EffectCostMeter::Options& options, std::size_t object,
                                    Worker::Control& control) {
    if (const Result<void> opened = control.openContext(); !opened) {
        return endOf(false, {opened.error()});
    }
    const auto meter = EffectCostMeter::create(subject, options);
    if (!meter) {
        return endOf(false, {meter.error()});
    }
    control.show([this, predicted = predictedFor(subject, control, object)] {
        if (measured_) {
            measured_->predicted = predicted;
        }
    });
    while (!(*meter)->finished() && !control.isCancelled()) {
        (*meter)->step();
        control.report((*meter)->progress());
    }
    control.show([this, costs = (*meter)->costs()] {
        if (measured_) {
            measured_->costs = costs;
        }
    });
    return endOf((*meter)->finished(), (*meter)->costs().problems);
}

void EffectMeasurement::forget() {
    worker_.cancel();
    measured_.reset();
}

bool EffectMeasurement::isStale() const {
    return !measured_ || measured_->object != document_.selection().object() ||
           !measured_->blocks.areIn(document_.sharedCatalog()) ||
           !(measured_->scene == document_.scene(document_.selection().side()));
}

const EffectCosts* EffectMeasurement::costs() const {
    const bool isOfObject = measured_ && measured_->object == document_.selection().object();
    return isOfObject ? &measured_->costs : nullptr;
}

const Result<PredictedEffects>* EffectMeasurement::predicted() const {
    return costs() != nullptr ? &measured_->predicted : nullptr;
}

QString EffectMeasurement::stateText(const std::vector<EffectRow>& rows) const {
    if (isRunning()) {
        return tr("Measuring …");
    }
    if (!measured_) {
        return tr("Costs are not measured yet.");
    }
    if (!measured_->end) {
        return tr("Could not be measured: %1").arg(problemText(measured_->end));
    }
    if (isStale()) {
        return whyStale();
    }
    return measured_->end.value_or(false) ? totalText(rows)
                                          : tr("Stopped. So far: %1").arg(totalText(rows));
}

QString EffectMeasurement::whyStale() const {
    const Side side = document_.selection().side();
    const bool hasSameObjects =
        measured_->scene.objects.size() == document_.scene(side).objects.size();
    if (hasSameObjects && measured_->object != document_.selection().object()) {
        return tr("Out of date: the costs were measured of another object.");
    }
    if (hasSameObjects && measured_->side != side) {
        return tr("Out of date: the costs were measured of the other side.");
    }
    return tr("Out of date: the scene has changed since the costs were measured.");
}

QString EffectMeasurement::totalText(const std::vector<EffectRow>& rows) const {
    const EffectCosts& costs = measured_->costs;
    const auto text = [](double milliseconds) {
        return numberLocale().toString(milliseconds, 'f', 2);
    };
    const QString total =
        tr("%1 ms a frame: effects %2 ms, the rest %3 ms. %4 × %5 pixels, %6.")
            .arg(text(costs.frame.median), text(sumOf(costs, rows)), text(costs.rest))
            .arg(costs.size.x)
            .arg(costs.size.y)
            .arg(asText(costs.method));
    return measured_->end.value_or(false) && costs.secondsNeeded > 0.0
               ? tr("%1 Frames are slow: ! has too few to be certain.").arg(total)
               : total;
}

} // namespace patina
