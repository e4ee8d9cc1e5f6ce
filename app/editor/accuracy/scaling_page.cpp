// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/scaling_page.h"

#include <utility>

#include <QVBoxLayout>

#include "accuracy/growth_plot.h"
#include "accuracy/measure_bar.h"
#include "catalog/json_text.h"
#include "document/document.h"
#include "session/session.h"
#include "text/png.h"

namespace patina {

namespace {

QString turnText(const ScalingSweep::Turn& turn) {
    const QString what = turn.round > 0
                             ? ScalingPage::tr("round %1 of %2").arg(turn.round).arg(turn.rounds)
                             : ScalingPage::tr("making programs");
    return ScalingPage::tr("Measuring, %1 of %2: %3, %4")
        .arg(turn.number)
        .arg(turn.of)
        .arg(GrowthPlot::nameOf(turn.axis), what);
}

QString methodOf(const ScalingSweep& sweep, int edge) {
    return ScalingPage::tr("%1; lights without shadows and copies of the object in pictures of "
                           "%2 × %2 pixels.")
        .arg(QString::fromStdString(sweep.timer()))
        .arg(edge);
}

using TakeCurves = std::function<void(const std::vector<ScalingCurve>&, const QString& method)>;

/// Runs in the worker's thread; `take` is called in the window's thread.
MeasureEnd sweepScaling(const CostSweep::Subject& subject, const ScalingSweep::Options& options,
                        Worker::Control& control, const TakeCurves& take) {
    const auto sweep = ScalingSweep::create(subject, options);
    if (!sweep) {
        return endOf(false, {sweep.error()});
    }
    int shown = 0;
    while (!(*sweep)->finished() && !control.isCancelled()) {
        (*sweep)->step();
        control.report((*sweep)->progress(), turnText((*sweep)->turn()));
        if ((*sweep)->rounds() != shown) {
            shown = (*sweep)->rounds();
            control.show([take, curves = (*sweep)->curves(),
                          method = methodOf(**sweep, options.edge)] { take(curves, method); });
        }
    }
    return endOf((*sweep)->finished(), (*sweep)->problems());
}

} // namespace

ScalingPage::ScalingPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn)
    : MeasurePage(context, std::move(turn),
                  tr("Measure the time of more pixels, lights and objects"),
                  {"csv", "json", "png"}),
      plots_(new QWidget(this)) {
    auto* row = new QHBoxLayout(plots_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    for (std::size_t i = 0; i < plot_.size(); ++i) {
        plot_[i] = new GrowthPlot(static_cast<ScalingCurve::Axis>(i), plots_);
        row->addWidget(plot_[i], 1);
    }
    rows().addWidget(plots_, 1);
    refresh();
}

void ScalingPage::startMeasuring() {
    measure({});
}

void ScalingPage::measure(ScalingSweep::Options options) {
    if (!canStart()) {
        return;
    }
    options.programCache = programFolder();
    const TakeCurves taken = [this](const std::vector<ScalingCurve>& curves,
                                    const QString& method) { take(curves, method); };
    start([subject = costSubject(), options = std::move(options), taken](Worker::Control& control) {
        return sweepScaling(subject, options, control, taken);
    });
}

MeasuredSubject ScalingPage::subject() const {
    return subjectOf(document().ownScene(document().selection().side()),
                     document().selection().object(), document().catalog());
}

void ScalingPage::showNumbers(bool stale) {
    for (std::size_t i = 0; i < plot_.size(); ++i) {
        std::optional<ScalingCurve> shown;
        for (const ScalingCurve& curve : curves()) {
            if (curve.axis == static_cast<ScalingCurve::Axis>(i)) {
                shown = curve;
            }
        }
        plot_[i]->setCurve(shown, stale);
    }
}

QByteArray ScalingPage::bytesFor(const QString& ending) const {
    if (ending == "png") {
        return asPng(plots_->grab().toImage());
    }
    return QByteArray::fromStdString(ending == "csv" ? scalingCsv(curves())
                                                     : writeJson(scalingJson(curves())));
}

} // namespace patina
