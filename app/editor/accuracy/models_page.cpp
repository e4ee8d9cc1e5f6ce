// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/models_page.h"

#include <utility>

#include <QVBoxLayout>

#include "accuracy/measure_bar.h"
#include "accuracy/model_list.h"
#include "catalog/json_text.h"
#include "document/document.h"
#include "measure/cost/ranking_table.h"
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
        .arg(numberLocale().toString(qulonglong(ranking.pixels())),
             QString::fromStdString(ranking.timer()));
}

using TakeCosts = std::function<void(const std::vector<ModelCost>&, const QString& method)>;

/// Runs in the worker's thread; `take` is called in the window's thread.
MeasureEnd rankModels(const CostSweep::Subject& subject, const CostSweep::Options& options,
                      Worker::Control& control, const TakeCosts& take) {
    const auto ranking = ModelRanking::create(subject, options);
    if (!ranking) {
        return endOf(false, {ranking.error()});
    }
    const auto show = [&] {
        std::vector<ModelCost> costs = (*ranking)->costs();
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
        control.tell((*ranking)->progress(), turnText(turn));
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
      list_(new ModelList(this)) {
    rows().addWidget(list_, 1);
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

/// Leaves out the object's own material, since every model is measured with its defaults.
MeasuredSubject ModelsPage::subject() const {
    const int object = document().selection().object();
    Scene scene = document().ownScene(document().selection().side());
    if (object >= 0) {
        scene.objects[static_cast<std::size_t>(object)].material = {};
    }
    return subjectOf(std::move(scene), object, document().catalog(), SubjectBlocks::All);
}

void ModelsPage::showNumbers(bool stale) {
    list_->setCosts(costs(), stale);
}

QByteArray ModelsPage::bytesFor(const QString& ending) const {
    return QByteArray::fromStdString(ending == "csv" ? rankingCsv(costs())
                                                     : writeJson(rankingJson(costs())));
}

} // namespace patina
