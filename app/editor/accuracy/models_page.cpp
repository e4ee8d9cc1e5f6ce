// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/models_page.h"

#include <map>
#include <utility>

#include <QVBoxLayout>

#include "accuracy/model_list.h"
#include "catalog/json_text.h"
#include "docks/family_chooser.h"
#include "document/document.h"
#include "measure/cost/ranking_table.h"
#include "measure/prediction/predicted_models.h"
#include "session/session.h"
#include "text/display_number.h"

namespace patina {

namespace {

QString turnText(const ModelRanking::Turn& turn) {
    return ModelsPage::tr("Measuring, model %1 of %2: %3")
        .arg(turn.number)
        .arg(turn.of)
        .arg(QString::fromStdString(turn.label));
}

QString methodOf(const ModelRanking& ranking) {
    return ModelsPage::tr("%1 pixels of the object; %2; times are beside the quickest.")
        .arg(wholeText(ranking.pixels()), QString::fromStdString(ranking.timer()));
}

using TakeCosts = std::function<void(const std::vector<ModelCost>&, const QString& method)>;

/// Holds what each model is on graphics cards that are not here, or why nothing is known of that.
class Predicted {
  public:
    Predicted(const CostSweep::Subject& subject, Worker::Control& control) {
        control.report(0.0, ModelsPage::tr("Compiling for other graphics cards"));
        std::vector<const GpuFamily*> families;
        for (const GpuFamily& family : gpuFamilies()) {
            families.push_back(&family);
        }
        FamilyCompilerOptions options;
        options.isStopped = [&control] { return control.isCancelled(); };
        auto models = predictedModels(
            {subject.scene, subject.object, subject.meshes, subject.catalog}, families, options);
        if (!models) {
            whyNot_ = models.error().front();
            return;
        }
        for (PredictedModel& model : models->models) {
            byModel_.insert_or_assign(std::move(model.model), std::move(model.statistics));
        }
    }

    void addTo(std::vector<ModelCost>& costs) const {
        for (ModelCost& cost : costs) {
            const auto found = byModel_.find(cost.model);
            cost.predicted = found != byModel_.end() ? found->second : tl::unexpected(whyNot_);
        }
    }

  private:
    std::map<std::string, Result<FamilyStatistics>> byModel_;
    Error whyNot_;
};

/// Runs in the worker's thread; `take` is called in the window's thread.
MeasureEnd rankModels(const CostSweep::Subject& subject, const CostSweep::Options& options,
                      Worker::Control& control, const TakeCosts& take) {
    const auto ranking = ModelRanking::create(subject, options);
    if (!ranking) {
        return endOf(false, {ranking.error()});
    }
    const Predicted predicted(subject, control);
    const auto show = [&] {
        std::vector<ModelCost> costs = (*ranking)->costs();
        predicted.addTo(costs);
        if (!costs.empty()) {
            control.show([take, costs = std::move(costs), method = methodOf(**ranking)] {
                take(costs, method);
            });
        }
    };
    std::size_t number = 0;
    while (!(*ranking)->finished() && !control.isCancelled()) {
        (*ranking)->step();
        const ModelRanking::Turn turn = (*ranking)->turn();
        control.report((*ranking)->progress(), turnText(turn));
        if (std::exchange(number, turn.number) != turn.number) {
            show();
        }
    }
    show();
    return endOf((*ranking)->finished(), (*ranking)->problems());
}

} // namespace

ModelsPage::ModelsPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn)
    : MeasurePage(context, std::move(turn), tr("Measure every model on this scene"),
                  {"csv", "json"}),
      family_(new FamilyChooser(this)), list_(new ModelList(this)) {
    rows().addWidget(family_, 0, Qt::AlignRight);
    rows().addWidget(list_, 1);
    list_->setFamily(family_->family());
    connect(family_, &QComboBox::currentIndexChanged, this, [this] {
        list_->setFamily(family_->family());
        showNumbers(isStale());
    });
    connect(list_, &ModelList::picked, this, [this](const QString& model) {
        document().setModel(document().selection().side(), model.toStdString());
    });
    refresh();
}

void ModelsPage::startMeasuring() {
    measure({});
}

void ModelsPage::measure(CostSweep::Options options) {
    if (!canStart()) {
        return;
    }
    options.programCache = programFolder();
    const TakeCosts taken = [this](const std::vector<ModelCost>& costs, const QString& method) {
        take(costs, method);
    };
    start([subject = costSubject(), options = std::move(options), taken](Worker::Control& control) {
        return rankModels(subject, options, control, taken);
    });
}

MeasuredSubject ModelsPage::subject() const {
    return subjectOfModels();
}

void ModelsPage::showNumbers(bool stale) {
    list_->setCatalog(document().sharedCatalog());
    list_->setCosts(costs(), stale);
}

QByteArray ModelsPage::bytesFor(const QString& ending) const {
    return QByteArray::fromStdString(ending == "csv" ? rankingCsv(costs())
                                                     : writeJson(rankingJson(costs())));
}

} // namespace patina
