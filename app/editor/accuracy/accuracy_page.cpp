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
#include "measure/cost/predicted_chart.h"
#include "session/session.h"
#include "text/as_text.h"

namespace patina {
namespace {

/// Is the time between two checks for cancellation, each of which may show new points.
constexpr std::chrono::milliseconds sweepSlice{100};
constexpr QSize usualPageSize{720, 320};
constexpr glm::ivec2 predictedSize{1920, 1080}; ///< are the pixels that predicted times are of
const QList<int> partSizes{2000, 3000};         ///< shares of the width: chart, table

std::unique_ptr<KeptResults> keptCharts(const ChartTarget& target, MessageLog& messages) {
    const bool isOfPicture = target.scope() == Choice::Scope::Picture;
    return std::make_unique<KeptCharts>(isOfPicture ? "picture" : "material", messages);
}

/// Compiles the ways of a chart of a material for all families of graphics cards.
Result<PredictedPoints> predictedOf(const CostChart& chart, const CostSweep::Subject& subject,
                                    Worker::Control& control) {
    std::vector<ChosenLevels> ways;
    for (const CostPoint& point : chart.points) {
        ways.push_back(point.levels);
    }
    std::vector<const GpuFamily*> families;
    for (const GpuFamily& family : gpuFamilies()) {
        families.push_back(&family);
    }
    FamilyCompilerOptions options;
    options.isStopped = [&control] { return control.isCancelled(); };
    Scene scene = subject.scene;
    scene.camera = subject.camera;
    control.report(1.0, AccuracyPage::tr("Compiling for other graphics cards"), true);
    return predictedPoints({std::move(scene), subject.object, subject.meshes, subject.catalog},
                           ways, families, options)
        .map_error([](const Errors& errors) { return errors.front(); });
}

using TakeChart = std::function<void(const MeasuredChart&)>;

/// Runs in the worker's thread; `take` is called in the window's thread.
MeasureEnd sweepCosts(const CostSweep::Subject& subject, const CostSweep::Options& options,
                      Worker::Control& control, const TakeChart& take) {
    const auto sweep = CostSweep::create(subject, options);
    if (!sweep) {
        return endOf(false, {sweep.error()});
    }
    MeasuredChart measured{subject.camera, {}, PredictedPoints()};
    const auto show = [&] {
        measured.chart = (*sweep)->chart();
        if (!measured.chart.points.empty()) {
            control.show([take, measured] { take(measured); });
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
    if (options.scope == Choice::Scope::Material && !(*sweep)->chart().points.empty() &&
        !control.isCancelled()) {
        measured.predicted = predictedOf((*sweep)->chart(), subject, control);
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
    if (target_->scope() != Choice::Scope::Material) {
        budget_->hideCards();
    }
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
    connect(budget_, &BudgetRow::cardChosen, this, [this] { refresh(); });
    connect(plot_, &CostPlot::selectionMoved, this, &AccuracyPage::select);
    connect(list_, &CostList::selectionMoved, this, &AccuracyPage::select);
    connect(budget_, &BudgetRow::answered, this, &AccuracyPage::select);
}

void AccuracyPage::addButton(QToolButton* button) {
    bar().addButton(button);
}

QSize AccuracyPage::sizeHint() const {
    return usualPageSize;
}

void AccuracyPage::showNumbers(bool stale) {
    const ChosenLevels current = target_->levels(target_->choices());
    const QString whyNot = predict();
    plot_->setChart(drawn_, current, stale);
    list_->setChart(drawn_, current, stale);
    budget_->setChart(drawn_, stale || isMeasuring());
    const bool hasNotes = !chart().points.empty() && !stale;
    notes_->setText(!hasNotes ? QString() : whyNot.isEmpty() ? notesText(drawn_) : whyNot);
    notes_->setVisible(!notes_->text().isEmpty());
    showSelected();
}

QString AccuracyPage::predict() {
    drawn_ = chart();
    const auto card = budget_->card();
    if (!card || drawn_.points.empty() || isMeasuring()) {
        return {};
    }
    const Result<PredictedPoints>& predicted = numbers<MeasuredChart>().predicted;
    const auto made = predicted ? predictedChart(drawn_, *predicted, *card, predictedSize)
                                : Result<CostChart>(tl::unexpected(predicted.error()));
    if (!made) {
        drawn_.points.clear();
        return asText(made.error().text());
    }
    drawn_ = *made;
    return {};
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
    const TakeChart taken = [this](const MeasuredChart& measured) {
        take(measured, methodText(measured.chart));
    };
    start([subject = std::move(subject), options = std::move(options), taken](
              Worker::Control& control) { return sweepCosts(subject, options, control, taken); });
}

/// A chart of another material or scene has other choices, and its points cannot be applied.
const CostPoint* AccuracyPage::pointAt(int point) const {
    const std::vector<CostPoint>& points = drawn_.points;
    const bool isThere = point >= 0 && point < static_cast<int>(points.size()) &&
                         drawn_.choices == target_->choices();
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
    QStringList lines{methodText(drawn_)};
    if (const QString driver = driverLine(); !driver.isEmpty()) {
        lines << driver;
    }
    const std::vector<Standing> standing = standings(drawn_.points);
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
        return QByteArray::fromStdString(costCsv(drawn_, name, true));
    }
    nlohmann::json json = costJson(drawn_);
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
    const QString method =
        drawn_.predictedFor.empty() ? MeasurePage::measuredText() : methodText(drawn_);
    return numbers<MeasuredChart>().camera == document().scene().camera
               ? method
               : tr("Measured from another view. %1").arg(method);
}

} // namespace patina
