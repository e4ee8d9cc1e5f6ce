// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/models_page.h"

#include <utility>

#include <QVBoxLayout>

#include "accuracy/measure_bar.h"
#include "accuracy/model_list.h"
#include "catalog/json_text.h"
#include "document.h"
#include "measure/ranking_table.h"
#include "number_text.h"
#include "session.h"

namespace patina {

class ModelsPage::Job : public SteppedWork::Job {
  public:
    Job(ModelsPage& page, std::unique_ptr<ModelRanking> ranking)
        : page_(page), ranking_(std::move(ranking)) {}

    void step() override { ranking_->step(); }
    bool finished() const override { return ranking_->finished(); }
    double progress() const override { return ranking_->progress(); }
    const Errors& problems() const override { return ranking_->problems(); }

    QString doing() const override {
        const ModelRanking::Turn turn = ranking_->turn();
        return tr("model %1 of %2: %3")
            .arg(turn.number)
            .arg(turn.of)
            .arg(QString::fromStdString(turn.label));
    }

    std::function<void()> news() override {
        std::vector<ModelCost> costs = ranking_->costs();
        if (costs.size() == told_) {
            return {};
        }
        told_ = costs.size();
        const QString method = tr("%1 pixels of the object; %2; times are beside the quickest.")
                                   .arg(numberLocale().toString(qulonglong(ranking_->pixels())),
                                        QString::fromStdString(ranking_->timer()));
        return [&page = page_, costs = std::move(costs), method] { page.take(costs, method); };
    }

  private:
    ModelsPage& page_;
    std::unique_ptr<ModelRanking> ranking_;
    std::size_t told_ = 0;
};

ModelsPage::ModelsPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn)
    : MeasurePage(context, std::move(turn), tr("Measure every model on this scene"),
                  {"csv", "json"}),
      list_(new ModelList(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->setSpacing(4);
    layout->addWidget(&bar());
    layout->addWidget(list_, 1);
    connect(list_, &ModelList::picked, this, [this](const QString& model) {
        document().setModel(document().activeSide(), model.toStdString());
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
    options.programCache = cacheFolder() / "programs";
    start([this, subject = costSubject(),
           options = std::move(options)]() -> Result<std::unique_ptr<SteppedWork::Job>> {
        auto ranking = ModelRanking::create(subject, options);
        if (!ranking) {
            return tl::unexpected(ranking.error());
        }
        return std::make_unique<Job>(*this, std::move(*ranking));
    });
}

/// Every model comes with its defaults: the object's own material does not matter.
Scene ModelsPage::measuredPart(Scene scene, int object) const {
    const auto index = static_cast<std::size_t>(object);
    if (object >= 0 && index < scene.objects.size()) {
        scene.objects[index].material = {};
    }
    return scene;
}

void ModelsPage::showNumbers(bool stale) {
    list_->setCosts(costs(), stale);
}

QByteArray ModelsPage::bytesFor(const QString& ending) const {
    return QByteArray::fromStdString(ending == "csv" ? rankingCsv(costs())
                                                     : writeJson(rankingJson(costs())));
}

} // namespace patina
