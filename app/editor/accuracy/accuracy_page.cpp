// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/accuracy_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "accuracy/budget_row.h"
#include "accuracy/chart_export.h"
#include "accuracy/cost_list.h"
#include "accuracy/cost_plot.h"
#include "accuracy/cost_subject.h"
#include "accuracy/cost_text.h"
#include "accuracy/long_line.h"
#include "accuracy/measure_turn.h"
#include "catalog/json_text.h"
#include "docks/panel.h"
#include "docks/settling.h"
#include "document/document.h"
#include "document/document_files.h"
#include "measure/cost/cost_table.h"
#include "resources/mesh_library.h"
#include "session/message_log.h"
#include "session/session.h"

namespace patina {
namespace {

constexpr int progressSteps = 1000;

/// Work between two looks at whether it was cancelled, each of which may show new points.
constexpr std::chrono::milliseconds sweepSlice{100};
constexpr int settleMs = 100;
constexpr QSize usualPageSize{720, 320};
const QList<int> partSizes{2000, 3000}; ///< of chart and table, as shares

} // namespace

AccuracyPage::AccuracyPage(const DockContext& context, std::unique_ptr<ChartTarget> target,
                           std::shared_ptr<MeasureTurn> turn)
    : document_(context.document), documentFiles_(context.documentFiles), library_(context.meshes),
      textures_(context.textures), environments_(context.environments), messages_(context.messages),
      target_(std::move(target)), turn_(std::move(turn)), store_(stateFolder() / "measurements"),
      start_(textButton(tr("Measure"), target_->measureText(), this)),
      cancel_(textButton(tr("Stop"), tr("Stop and keep what was measured so far"), this)),
      compare_(textButton(tr("Compare with exact"),
                          tr("Show the exact way in A, the selected one in B and how far they are "
                             "apart in C"),
                          this)),
      export_(textButton(tr("Export"), tr("Write what was measured to a file"), this)),
      progress_(new QProgressBar(this)), state_(new LongLine(this)), notes_(hintLabel(this)),
      plot_(new CostPlot(this)), list_(new CostList(this)), budget_(new BudgetRow(this)) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    makeExportMenu();
    layOut();
    connectParts();
    showState();
}

void AccuracyPage::layOut() {
    progress_->setRange(0, progressSteps);
    progress_->setMaximumWidth(200);
    progress_->setAccessibleName(tr("Progress of the measurement"));
    state_->setObjectName("state");
    state_->setWordWrap(true);
    state_->setMinimumHeight(2 * fontMetrics().lineSpacing()); // another text moves nothing
    notes_->setObjectName("notes");
    notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* row = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{start_, cancel_, progress_}) {
        row->addWidget(widget);
    }
    row->addWidget(state_, 1);
    row->addWidget(compare_);
    row->addWidget(export_);
    auto* parts = new QSplitter(this);
    parts->setChildrenCollapsible(false);
    parts->addWidget(plot_);
    parts->addWidget(list_);
    parts->setStretchFactor(0, 2);
    parts->setStretchFactor(1, 3);
    parts->setSizes(partSizes);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(budget_);
    layout->addWidget(parts, 1);
    layout->addWidget(notes_);
}

void AccuracyPage::makeExportMenu() {
    auto* menu = new QMenu(export_);
    for (const char* ending : {"csv", "json", "png", "svg"}) {
        const QString name = QString::fromLatin1(ending);
        menu->addAction(tr("As %1…").arg(name.toUpper()), this, [this, name] {
            const QString file = askForChartFile(this, name);
            if (!file.isEmpty()) {
                exportTo(file);
            }
        });
    }
    export_->setMenu(menu);
    export_->setPopupMode(QToolButton::InstantPopup);
}

void AccuracyPage::connectParts() {
    connect(start_, &QToolButton::clicked, this, [this] { measure(); });
    connect(cancel_, &QToolButton::clicked, &measurement_, &BackgroundJob::cancel);
    connect(compare_, &QToolButton::clicked, this, [this] { compare(list_->selected()); });
    connect(plot_, &CostPlot::picked, this, &AccuracyPage::apply);
    connect(list_, &CostList::picked, this, &AccuracyPage::apply);
    connect(budget_, &BudgetRow::wished, this, &AccuracyPage::apply);
    connect(plot_, &CostPlot::selectionMoved, this, &AccuracyPage::select);
    connect(list_, &CostList::selectionMoved, this, &AccuracyPage::select);
    connect(budget_, &BudgetRow::answered, this, &AccuracyPage::select);
    connect(&measurement_, &BackgroundJob::finished, this, &AccuracyPage::finish);
    connect(turn_.get(), &MeasureTurn::changed, this, &AccuracyPage::showState);
    connect(&settle_, &QTimer::timeout, this, &AccuracyPage::follow);
    startWhenChanged(settle_, document_, library_);
    connect(&documentFiles_, &DocumentFiles::fileChanged, &settle_, qOverload<>(&QTimer::start));
}

void AccuracyPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    follow();
}

void AccuracyPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && isVisible()) {
        showChart(shown_); // its marks have the palette's colours
    }
}

QSize AccuracyPage::sizeHint() const {
    return usualPageSize;
}

/// Finds the chart of what is on the screen now. Nobody sees it in a dock that is not open.
void AccuracyPage::follow() {
    if (!isVisible()) {
        return;
    }
    choices_ = target_->choices();
    showChart(running_ ? &*running_ : keptFor(target_->subject()));
}

std::string AccuracyPage::file() const {
    return documentFiles_.file().path.string();
}

void AccuracyPage::showChart(const KeptChart* chart) {
    static const CostChart none;
    shown_ = chart;
    stale_ = shown_ != nullptr && !(shown_->subject == target_->subject());
    const ChosenLevels current = target_->levels(choices_);
    const CostChart& points = shown_ != nullptr ? shown_->chart : none;
    plot_->setChart(points, current, stale_);
    list_->setChart(points, current, stale_);
    budget_->setChart(points, stale_ || running_.has_value());
    showState();
}

void AccuracyPage::select(int point) {
    plot_->select(point);
    list_->select(point);
    showState();
}

void AccuracyPage::measure() {
    measure({});
}

void AccuracyPage::measure(CostSweep::Options options) {
    const int object = document_.currentObject();
    if (measurement_.isRunning() || object < 0 || !turn_->take(*this)) {
        return;
    }
    running_ = KeptChart{target_->subject(), file(), document_.scene().camera, {}, false, {}};
    running_->chart.choices = target_->choices();
    step_ = {};
    options.programCache = cacheFolder() / "programs";
    options.scope = target_->scope();
    options.present = target_->levels(running_->chart.choices);
    progress_->setValue(0);
    measurement_.start(
        withContext([this, subject = costSubject(document_, library_, textures_, environments_),
                     options = std::move(options)](BackgroundJob::Control& control) {
            return sweep(subject, options, control);
        }));
    select(-1);
    showChart(&*running_);
}

/// In the worker's thread.
BackgroundJob::End AccuracyPage::sweep(const CostSweep::Subject& subject,
                                       const CostSweep::Options& options,
                                       BackgroundJob::Control& control) {
    const auto sweep = CostSweep::create(subject, options);
    if (!sweep) {
        return endOf(false, {sweep.error()});
    }
    std::size_t shown = 0;
    while (!(*sweep)->finished() && !control.isCancelled()) {
        (*sweep)->step(sweepSlice);
        control.show([this, step = (*sweep)->doing()] { showStep(step); });
        if ((*sweep)->chart().points.size() > shown) {
            shown = (*sweep)->chart().points.size();
            control.show([this, chart = (*sweep)->chart()] { showRunning(chart); });
        }
    }
    control.show([this, chart = (*sweep)->chart()] { showRunning(chart); });
    return endOf((*sweep)->finished(), (*sweep)->problems());
}

void AccuracyPage::showStep(const SweepStep& step) {
    step_ = step;
    progress_->setValue(static_cast<int>(std::lround(step.progress() * progressSteps)));
    showState();
}

void AccuracyPage::showRunning(const CostChart& chart) {
    if (running_) {
        running_->chart = chart;
        showChart(&*running_);
    }
}

void AccuracyPage::finish(bool complete, const QString& problem) {
    turn_->giveBack(*this);
    if (!running_) {
        return;
    }
    running_->complete = complete;
    running_->problem = problem.toStdString();
    const KeptChart& kept = charts_.keep(std::move(*running_));
    running_.reset();
    store(kept);
    showChart(&kept);
    follow();
}

ChartKey AccuracyPage::keyOf(const std::string& file, int object) const {
    const bool isOfPicture = target_->scope() == Choice::Scope::Picture;
    return {isOfPicture ? "picture" : "material", file, object};
}

const std::string& AccuracyPage::device() {
    if (!device_) {
        device_ = driverLine().toStdString();
    }
    return *device_;
}

/// What was measured of this subject, else what was measured last of the document's object.
const KeptChart* AccuracyPage::keptFor(const MeasuredSubject& subject) {
    const KeptChart* kept = charts_.find(subject, file());
    const bool isFresh = kept != nullptr && kept->subject == subject;
    if (!isFresh) {
        const KeptChart* older = fromBefore(subject);
        return older != nullptr ? older : kept;
    }
    if (!stored_.contains(keyOf(file(), subject.object))) { // it has been saved under that name
        store(*kept);
    }
    return kept;
}

/// What an earlier session measured. What is of another subject is shown as out of date, but only
/// of a document that has a file: others have nothing to do with each other.
const KeptChart* AccuracyPage::fromBefore(const MeasuredSubject& subject) {
    const ChartKey key = keyOf(file(), subject.object);
    read(key);
    const auto found = before_.find(key);
    if (found == before_.end()) {
        return nullptr;
    }
    if (found->second.hash != hashOf(subject, device())) {
        return key.file.empty() ? nullptr : &found->second.chart;
    }
    KeptChart chart = std::move(found->second.chart);
    before_.erase(found);
    chart.subject = subject;
    return &charts_.keep(std::move(chart));
}

/// Once: what is measured later is written over it.
void AccuracyPage::read(const ChartKey& key) {
    if (!stored_.insert(key).second) {
        return;
    }
    auto chart = store_.read(key);
    if (!chart) {
        messages_.add(chart.error());
    } else if (*chart) {
        before_.insert_or_assign(key, std::move(**chart));
    }
}

void AccuracyPage::store(const KeptChart& chart) {
    const ChartKey key = keyOf(chart.file, chart.subject.object);
    if (chart.chart.points.empty()) {
        return;
    }
    stored_.insert(key);
    before_.erase(key);
    const auto written = store_.write(key, {chart, hashOf(chart.subject, device())});
    if (!written) {
        messages_.add(written.error());
    }
}

const CostPoint* AccuracyPage::pointAt(int point) const {
    const bool isThere = shown_ != nullptr && point >= 0 &&
                         point < static_cast<int>(shown_->chart.points.size()) &&
                         shown_->chart.choices == choices_;
    return isThere ? &shown_->chart.points[static_cast<std::size_t>(point)] : nullptr;
}

void AccuracyPage::apply(int point) {
    choices_ = target_->choices();
    if (const CostPoint* chosen = pointAt(point)) {
        target_->apply(choices_, chosen->levels,
                       tr("Accuracy: %1").arg(wayName(*chosen, shown_->chart)));
    }
}

void AccuracyPage::compare(int point) {
    choices_ = target_->choices();
    if (const CostPoint* chosen = pointAt(point)) {
        target_->compare(choices_, chosen->levels);
    }
}

std::string AccuracyPage::subjectName() const {
    const Material* material = document_.material(document_.activeSide());
    return material != nullptr ? material->name : std::string();
}

ChartHeading AccuracyPage::heading() const {
    const QString name = QString::fromStdString(subjectName());
    const QString title = tr("What accuracy costs");
    QStringList lines{methodText(shown_->chart)};
    if (const QString driver = driverLine(); !driver.isEmpty()) {
        lines << driver;
    }
    const std::vector<Standing> standing = standings(shown_->chart.points);
    if (std::ranges::find(standing, Standing::Tie) != standing.end()) {
        lines << tr("A circle in the line's colour may be on it, too: the difference is within the "
                    "noise.");
    }
    return {name.isEmpty() ? title : QStringLiteral("%1: %2").arg(title, name), lines};
}

QByteArray AccuracyPage::bytesFor(const QString& ending) const {
    const CostChart& chart = shown_->chart;
    if (ending == "png") {
        return plot_->png(heading());
    }
    if (ending == "svg") {
        return plot_->svg(heading());
    }
    const std::string name = subjectName();
    if (ending == "csv") {
        return QByteArray::fromStdString(costCsv(chart, name, true));
    }
    nlohmann::json json = costJson(chart);
    json["preset"] = name;
    return QByteArray::fromStdString(writeJson(json));
}

void AccuracyPage::exportTo(const QString& file) {
    if (shown_ == nullptr) {
        return;
    }
    const QByteArray bytes = bytesFor(QFileInfo(file).suffix().toLower());
    const auto written = writeFileAtomically(file.toStdString(), bytes.toStdString());
    if (!written) {
        messages_.add(written.error());
    }
}

QString AccuracyPage::stateText() const {
    if (document_.currentObject() < 0) {
        return tr("There is no object.");
    }
    if (measurement_.isRunning()) {
        return stepText(step_, running_->chart);
    }
    if (choices_.empty()) {
        return target_->noChoicesText();
    }
    if (shown_ == nullptr) {
        const QString whyNot = turn_->whyNot(*this);
        return whyNot.isEmpty() ? tr("Nothing is measured yet.") : whyNot;
    }
    if (!shown_->problem.empty()) {
        return tr("Could not be measured: %1").arg(QString::fromStdString(shown_->problem));
    }
    if (stale_) {
        return staleStateText();
    }
    return shown_->complete ? measuredText() : tr("Stopped. %1").arg(measuredText());
}

/// What is chosen by an old point is chosen, whatever the numbers are by now.
QString AccuracyPage::staleStateText() const {
    const QString why = tr("Out of date: the material or the scene has changed since.");
    const CostPoint* now =
        shown_->chart.choices == choices_ ? shown_->chart.find(target_->levels(choices_)) : nullptr;
    return now != nullptr ? tr("%1 Chosen now: %2.").arg(why, wayName(*now, shown_->chart)) : why;
}

QString AccuracyPage::measuredText() const {
    const QString method = methodText(shown_->chart);
    return shown_->camera == document_.scene().camera
               ? method
               : tr("Measured from another view. %1").arg(method);
}

void AccuracyPage::showState() {
    const bool running = measurement_.isRunning();
    const bool hasPoints = shown_ != nullptr && !shown_->chart.points.empty();
    const QString whyNot = turn_->whyNot(*this);
    start_->setEnabled(!choices_.empty() && whyNot.isEmpty());
    start_->setToolTip(whyNot.isEmpty() ? target_->measureText() : whyNot);
    start_->setVisible(!running);
    cancel_->setVisible(running);
    progress_->setVisible(running);
    compare_->setEnabled(pointAt(list_->selected()) != nullptr);
    export_->setEnabled(hasPoints);
    state_->tell(stateText());
    notes_->setText(hasPoints && !stale_ ? notesText(shown_->chart) : QString());
    notes_->setVisible(!notes_->text().isEmpty());
}

} // namespace patina
