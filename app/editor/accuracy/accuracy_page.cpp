// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/accuracy_page.h"

#include <algorithm>
#include <utility>

#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "accuracy/budget_row.h"
#include "accuracy/chart_export.h"
#include "accuracy/cost_list.h"
#include "accuracy/cost_plot.h"
#include "accuracy/cost_text.h"
#include "accuracy/kept_charts.h"
#include "accuracy/measure_bar.h"
#include "catalog/json_text.h"
#include "docks/panel.h"
#include "document/document.h"
#include "measure/cost/cost_table.h"
#include "session/session.h"

namespace patina {
namespace {

/// Is the time between two checks for cancellation, each of which may show new points.
constexpr std::chrono::milliseconds sweepSlice{100};
constexpr QSize usualPageSize{720, 320};
const QList<int> partSizes{2000, 3000}; ///< shares of the width: chart, table

std::unique_ptr<KeptResults> keptCharts(const ChartTarget& target, MessageLog& messages) {
    const bool isOfPicture = target.scope() == Choice::Scope::Picture;
    return std::make_unique<KeptCharts>(isOfPicture ? "picture" : "material", messages);
}

/// Runs in the worker's thread; `take` is called in the window's thread.
MeasureEnd sweepCosts(const CostSweep::Subject& subject, const CostSweep::Options& options,
                      Worker::Control& control, const std::function<void(const CostChart&)>& take) {
    const auto sweep = CostSweep::create(subject, options);
    if (!sweep) {
        return endOf(false, {sweep.error()});
    }
    const auto show = [&] {
        if (!(*sweep)->chart().points.empty()) {
            control.show([take, chart = (*sweep)->chart()] { take(chart); });
        }
    };
    std::size_t shown = 0;
    std::size_t told = 0;
    while (!(*sweep)->finished() && !control.isCancelled()) {
        (*sweep)->step(sweepSlice);
        const SweepStep step = (*sweep)->doing();
        const bool isAnother = step.of > 1 && std::exchange(told, step.number) != step.number;
        control.report(step.progress(), stepText(step, (*sweep)->chart()), isAnother);
        const std::size_t points = (*sweep)->chart().points.size();
        if (std::exchange(shown, points) != points) {
            show();
        }
    }
    show();
    return endOf((*sweep)->finished(), (*sweep)->problems());
}

} // namespace

AccuracyPage::AccuracyPage(const DockContext& context, std::unique_ptr<ChartTarget> target,
                           std::shared_ptr<MeasureTurn> turn)
    : MeasurePage(context, std::move(turn), target->measureText(), {"csv", "json", "png", "svg"},
                  keptCharts(*target, context.messages)),
      target_(std::move(target)),
      compare_(textButton(tr("Compare with exact"),
                          tr("Show the exact way in A, the selected one in B and how far they are "
                             "apart beside them"),
                          this)),
      notes_(hintLabel(this)), plot_(new CostPlot(this)), list_(new CostList(this)),
      budget_(new BudgetRow(this)) {
    layOut();
    connectParts();
    showSelected();
}

void AccuracyPage::layOut() {
    bar().addButton(compare_);
    bar().giveTwoLines();
    notes_->setObjectName("notes");
    notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    notes_->hide();
    auto* parts = new QSplitter(this);
    parts->setChildrenCollapsible(false);
    parts->addWidget(plot_);
    parts->addWidget(list_);
    parts->setStretchFactor(0, 2);
    parts->setStretchFactor(1, 3);
    parts->setSizes(partSizes);
    rows().addWidget(budget_);
    rows().addWidget(parts, 1);
    rows().addWidget(notes_);
}

void AccuracyPage::connectParts() {
    connect(compare_, &QToolButton::clicked, this, [this] { compare(list_->selected()); });
    connect(plot_, &CostPlot::picked, this, &AccuracyPage::apply);
    connect(list_, &CostList::picked, this, &AccuracyPage::apply);
    connect(budget_, &BudgetRow::wished, this, &AccuracyPage::apply);
    connect(plot_, &CostPlot::selectionMoved, this, &AccuracyPage::select);
    connect(list_, &CostList::selectionMoved, this, &AccuracyPage::select);
    connect(budget_, &BudgetRow::answered, this, &AccuracyPage::select);
}

QSize AccuracyPage::sizeHint() const {
    return usualPageSize;
}

void AccuracyPage::showNumbers(bool stale) {
    const ChosenLevels current = target_->levels(target_->choices());
    plot_->setChart(chart(), current, stale);
    list_->setChart(chart(), current, stale);
    budget_->setChart(chart(), stale || isMeasuring());
    notes_->setText(chart().points.empty() || stale ? QString() : notesText(chart()));
    notes_->setVisible(!notes_->text().isEmpty());
    showSelected();
}

void AccuracyPage::select(int point) {
    plot_->select(point);
    list_->select(point);
    showSelected();
}

void AccuracyPage::showSelected() {
    compare_->setEnabled(pointAt(list_->selected()) != nullptr);
}

void AccuracyPage::measure(CostSweep::Options options) {
    if (!canStart()) {
        return;
    }
    options.programCache = programFolder();
    options.scope = target_->scope();
    options.present = target_->levels(target_->choices());
    select(-1);
    CostSweep::Subject subject = costSubject();
    const auto take = [this, camera = subject.camera](const CostChart& chart) {
        takeChart(camera, chart);
    };
    start([subject = std::move(subject), options = std::move(options),
           take](Worker::Control& control) { return sweepCosts(subject, options, control, take); });
}

void AccuracyPage::takeChart(const Camera& camera, const CostChart& chart) {
    take(MeasuredChart{camera, chart}, methodText(chart));
}

/// A chart of another material or scene has other choices, and its points cannot be applied.
const CostPoint* AccuracyPage::pointAt(int point) const {
    const std::vector<CostPoint>& points = chart().points;
    const bool isThere = point >= 0 && point < static_cast<int>(points.size()) &&
                         chart().choices == target_->choices();
    return isThere ? &points[static_cast<std::size_t>(point)] : nullptr;
}

void AccuracyPage::apply(int point) {
    if (const CostPoint* chosen = pointAt(point)) {
        target_->apply(chart().choices, chosen->levels,
                       tr("Accuracy: %1").arg(settingName(*chosen, chart())));
    }
}

void AccuracyPage::compare(int point) {
    if (const CostPoint* chosen = pointAt(point)) {
        target_->compare(chart().choices, chosen->levels);
    }
}

std::string AccuracyPage::subjectName() const {
    const Material* material = document().material(document().selection().side());
    return material != nullptr ? material->name : std::string();
}

ChartHeading AccuracyPage::heading() const {
    const QString name = QString::fromStdString(subjectName());
    const QString title = tr("What accuracy costs");
    QStringList lines{shown()->method};
    if (const QString driver = driverLine(); !driver.isEmpty()) {
        lines << driver;
    }
    const std::vector<Standing> standing = standings(chart().points);
    if (std::ranges::find(standing, Standing::Tie) != standing.end()) {
        lines << tr("A circle in the line's colour may be on it, too: the difference is within the "
                    "noise.");
    }
    return {name.isEmpty() ? title : QStringLiteral("%1: %2").arg(title, name), lines};
}

QByteArray AccuracyPage::bytesFor(const QString& ending) const {
    if (ending == "png") {
        return plot_->png(heading());
    }
    if (ending == "svg") {
        return plot_->svg(heading());
    }
    const std::string name = subjectName();
    if (ending == "csv") {
        return QByteArray::fromStdString(costCsv(chart(), name, true));
    }
    nlohmann::json json = costJson(chart());
    json["preset"] = name;
    return QByteArray::fromStdString(writeJson(json));
}

QString AccuracyPage::nothingText() const {
    const QString nothing = MeasurePage::nothingText();
    return nothing.isEmpty() && target_->choices().empty() ? target_->noChoicesText() : nothing;
}

/// The levels of a stale point are still valid, only its numbers are old.
QString AccuracyPage::outOfDateText() const {
    const QString why = tr("Out of date: the material or the scene has changed since.");
    const CostPoint* now = chart().choices == target_->choices()
                               ? chart().find(target_->levels(chart().choices))
                               : nullptr;
    return now != nullptr ? tr("%1 Chosen now: %2.").arg(why, settingName(*now, chart())) : why;
}

QString AccuracyPage::measuredText() const {
    const QString method = MeasurePage::measuredText();
    return numbers<MeasuredChart>().camera == document().scene().camera
               ? method
               : tr("Measured from another view. %1").arg(method);
}

} // namespace patina
