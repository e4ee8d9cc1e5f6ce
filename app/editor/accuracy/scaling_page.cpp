// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/scaling_page.h"

#include <utility>

#include <QBuffer>
#include <QPixmap>
#include <QVBoxLayout>

#include "accuracy/growth_plot.h"
#include "accuracy/measure_bar.h"
#include "catalog/json_text.h"
#include "document.h"
#include "session.h"

namespace patina {

class ScalingPage::Job : public SteppedWork::Job {
  public:
    Job(ScalingPage& page, std::unique_ptr<ScalingSweep> sweep, int edge)
        : page_(page), sweep_(std::move(sweep)), edge_(edge) {}

    void step() override { sweep_->step(); }
    bool finished() const override { return sweep_->finished(); }
    double progress() const override { return sweep_->progress(); }
    const Errors& problems() const override { return sweep_->problems(); }

    QString doing() const override {
        const ScalingSweep::Turn turn = sweep_->turn();
        const QString what = turn.round > 0
                                 ? tr("round %1 of %2").arg(turn.round).arg(turn.rounds)
                                 : tr("making programs");
        return tr("%1 of %2: %3, %4")
            .arg(turn.number)
            .arg(turn.of)
            .arg(GrowthPlot::nameOf(turn.axis), what);
    }

    std::function<void()> news() override {
        if (sweep_->rounds() == told_) {
            return {};
        }
        told_ = sweep_->rounds();
        const QString method = tr("%1; lights without shadows and copies of the object in pictures "
                                  "of %2 × %2 pixels.")
                                   .arg(QString::fromStdString(sweep_->timer()))
                                   .arg(edge_);
        return
            [&page = page_, curves = sweep_->curves(), method] { page.take(curves, method); };
    }

  private:
    ScalingPage& page_;
    std::unique_ptr<ScalingSweep> sweep_;
    int edge_;
    int told_ = 0;
};

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
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->setSpacing(4);
    layout->addWidget(&bar());
    layout->addWidget(plots_, 1);
    refresh();
}

void ScalingPage::startMeasuring() {
    measure({});
}

void ScalingPage::measure(ScalingSweep::Options options) {
    if (!canStart()) {
        return;
    }
    options.programCache = cacheFolder() / "programs";
    start([this, subject = costSubject(),
           options = std::move(options)]() -> Result<std::unique_ptr<SteppedWork::Job>> {
        auto sweep = ScalingSweep::create(subject, options);
        if (!sweep) {
            return tl::unexpected(sweep.error());
        }
        return std::make_unique<Job>(*this, std::move(*sweep), options.edge);
    });
}

Scene ScalingPage::measuredPart(Scene scene, int) const {
    return scene;
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
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        plots_->grab().save(&buffer, "PNG");
        return bytes;
    }
    return QByteArray::fromStdString(ending == "csv" ? scalingCsv(curves())
                                                     : writeJson(scalingJson(curves())));
}

} // namespace patina
