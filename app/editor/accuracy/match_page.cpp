// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/match_page.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "accuracy/match_plot.h"
#include "accuracy/number_row.h"
#include "catalog/json_text.h"
#include "docks/panel.h"
#include "document/document.h"
#include "measure/cost/model_ranking.h"
#include "session/session.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "viewport/side_view.h"

namespace patina {
namespace {

constexpr std::size_t samples = 4096;
constexpr double within = 0.02; ///< is the relative error that the sentence speaks of

constexpr int modelColumn = 0;
constexpr int errorColumn = 1;
constexpr int relativeColumn = 2;
constexpr int timeColumn = 3;
constexpr int matchRole = Qt::UserRole; ///< is for the index of a match

/// Holds what a fit needs, so that it can be made in another thread.
struct MatchTask {
    std::shared_ptr<const Catalog> catalog;
    std::optional<Material> material; ///< is empty where a file is the aim
    std::filesystem::path file;
    Material own;
    bool fitsAll = false;
    FitOptions fit{};
    CostSweep::Subject subject; ///< is what the fits are drawn on to be timed
    CostSweep::Options options{};
};

using TakeMatches = std::function<void(const ModelMatches&)>;

Checked<MatchAim> aimOf(const MatchTask& task) {
    if (!task.material) {
        return readMatchAim(task.file, *task.catalog, samples);
    }
    auto aim = matchAim(*task.material, *task.catalog, samples);
    return aim ? Checked<MatchAim>(std::move(*aim)) : tl::unexpected(oneError(aim.error()));
}

/// Measures how long the fitted materials take per pixel of the object, and shows what is known
/// after each model's turn.
Errors timeMatches(const MatchTask& task, ModelMatches& matches, Worker::Control& control,
                   const TakeMatches& take) {
    std::vector<Material> materials;
    for (const ModelMatch& row : matches.rows) {
        materials.push_back(row.material);
    }
    const auto ranking = ModelRanking::create(task.subject, task.options, std::move(materials));
    if (!ranking) {
        return {ranking.error()};
    }
    const auto show = [&] {
        std::map<std::string, double> nanoseconds;
        for (const ModelCost& cost : (*ranking)->costs()) {
            nanoseconds[cost.model] = cost.cost.nanosecondsPerPixel;
        }
        addTimes(matches, nanoseconds);
        control.show([take, matches] { take(matches); });
    };
    std::size_t number = 0;
    while (!(*ranking)->finished() && !control.isCancelled()) {
        (*ranking)->step();
        const ModelRanking::Turn turn = (*ranking)->turn();
        control.report((*ranking)->progress(), MatchPage::tr("Measuring times"));
        if (std::exchange(number, turn.number) != turn.number) {
            show();
        }
    }
    show();
    return (*ranking)->problems();
}

/// Runs in the worker's thread; `take` is called in the window's thread.
MeasureEnd fit(const MatchTask& task, Worker::Control& control, const TakeMatches& take) {
    const Checked<MatchAim> aim = aimOf(task);
    if (!aim) {
        return endOf(false, aim.error());
    }
    std::vector<Material> starts;
    const Block* own = task.catalog->find(kinds::models, task.own.model.id);
    for (const Block* model : task.fitsAll ? matchedModels(*task.catalog) : std::vector{own}) {
        if (model != nullptr) {
            starts.push_back(matchStart(task.own, *aim, *model, *task.catalog));
        }
    }
    std::size_t shown = 0;
    ModelMatches matches = fittedMaterials(
        starts, aim->target, task.fit, *task.catalog, [&](double done, const ModelMatches& soFar) {
            control.report(done, MatchPage::tr("Fitting models"));
            if (soFar.rows.size() > shown) {
                shown = soFar.rows.size();
                control.show([take, soFar] { take(soFar); });
            }
            return !control.isCancelled();
        });
    control.show([take, matches] { take(matches); });
    Errors problems = matches.problems;
    if (!matches.rows.empty() && !control.isCancelled()) {
        addNew(problems, timeMatches(task, matches, control, take));
    }
    return endOf(!control.isCancelled(), problems);
}

} // namespace

MatchPage::MatchPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn)
    : MeasurePage(context, std::move(turn), tr("Find the values that look like what is chosen"),
                  {"csv", "json"}, std::make_unique<KeptResults>(), tr("Matching")),
      aim_(new QComboBox(this)), error_(new QComboBox(this)),
      all_(new QCheckBox(tr("All models"), this)), list_(new QTreeWidget(this)),
      plot_(new MatchPlot([this](int match) { select(match); }, this)) {
    rows().addWidget(makeControls());
    list_->setAccessibleName(tr("Fitted models"));
    list_->setHeaderLabels({tr("Model"), tr("Error"), tr("Relative"), tr("ns/pixel")});
    list_->headerItem()->setToolTip(errorColumn,
                                    tr("Root of the mean square of what is made small"));
    list_->headerItem()->setToolTip(
        relativeColumn,
        tr("Root of the squared differences' sum, of that of the target's squares"));
    list_->headerItem()->setToolTip(
        timeColumn, tr("Nanoseconds for each pixel of the object with the fitted values"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->header()->setStretchLastSection(false);
    list_->setSortingEnabled(true);
    list_->sortByColumn(errorColumn, Qt::AscendingOrder);
    list_->setColumnWidth(modelColumn, 190);
    fitColumns(*list_, errorColumn);
    auto* beside = new QSplitter(this); // the panel is wide and low
    beside->addWidget(list_);
    beside->addWidget(plot_);
    beside->setStretchFactor(0, 3);
    beside->setStretchFactor(1, 2);
    rows().addWidget(beside, 1);
    connect(list_, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* row) { apply(row->data(modelColumn, matchRole).toInt()); });
    onChange(document(),
             DocumentChange::Comparing | DocumentChange::Material | DocumentChange::Current |
                 DocumentChange::Snapshots,
             this, [this] { listAims(); });
    listAims();
    refresh();
}

QWidget* MatchPage::makeControls() {
    aim_->setObjectName("aim");
    aim_->setAccessibleName(tr("What is to be matched"));
    aim_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    all_->setObjectName("all models");
    all_->setChecked(true);
    all_->setToolTip(tr("Fit every model that reflects light, not the object's alone"));
    error_->setObjectName("error");
    error_->setAccessibleName(tr("What is made small"));
    const auto addError = [this](MatchError error, const QString& name, const QString& what) {
        error_->addItem(name, static_cast<int>(error));
        error_->setItemData(error_->count() - 1, what, Qt::ToolTipRole);
    };
    addError(MatchError::Log, tr("Log error"),
             tr("ln(1 + m) - ln(1 + t) of model and target: a highlight does not hide the rest"));
    addError(MatchError::Relative, tr("Relative error"),
             tr("(m - t) / (t + 0.01): dark directions count as much as bright ones"));
    addError(MatchError::Linear, tr("Linear error"),
             tr("m - t: the brightest directions count most"));
    addError(MatchError::Lightness, tr("Lightness error"),
             tr("L*(m) - L*(t), CIE's lightness, 1 for white: dark and bright count as the eye has "
                "them"));
    error_->setToolTip(tr("What a fit makes small; all count flat directions by their cosine"));
    auto* open = textButton(tr("File…"), tr("Match a preset or a measured surface"), this);
    connect(open, &QToolButton::clicked, this, [this] { askForFile(); });
    auto* row = new QWidget(this);
    auto* widgets = new QHBoxLayout(row);
    widgets->setContentsMargins(0, 0, 0, 0);
    widgets->addWidget(new QLabel(tr("To"), row));
    widgets->addWidget(aim_);
    widgets->addWidget(open);
    widgets->addWidget(error_);
    widgets->addWidget(all_);
    widgets->addStretch(1);
    return row;
}

/// Lists the materials of the other views, the snapshots and the file that was chosen.
void MatchPage::listAims() {
    const QString kept = aim_->currentText();
    aims_.clear();
    for (std::size_t i = 0; i < document().shownSides(); ++i) {
        if (sides[i] != document().selection().side()) {
            aims_.push_back({tr("View %1").arg(letterOf(sides[i])), sides[i]});
        }
    }
    for (const Snapshot& snapshot : document().state().snapshots) {
        aims_.push_back({asText(snapshot.name)});
    }
    if (!file_.empty()) {
        aims_.push_back({asText(file_.filename().string()), std::nullopt, file_});
    }
    const QSignalBlocker blocker(aim_);
    aim_->clear();
    for (const Aim& aim : aims_) {
        aim_->addItem(aim.name);
    }
    aim_->setCurrentIndex(std::max(aim_->findText(kept), aims_.empty() ? -1 : 0));
    aim_->setEnabled(!aims_.empty());
}

const Material* MatchPage::materialOf(const Aim& aim) const {
    if (aim.side) {
        return document().material(*aim.side);
    }
    const std::vector<Snapshot>& snapshots = document().state().snapshots;
    const auto found = std::ranges::find(snapshots, aim.name.toStdString(), &Snapshot::name);
    return aim.file.empty() && found != snapshots.end() ? &found->material : nullptr;
}

void MatchPage::askForFile() {
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Match"), {}, tr("Presets and measured surfaces (*.patina.json *.binary *.bsdf)"));
    if (!file.isEmpty()) {
        aimAt(file.toStdString());
    }
}

void MatchPage::aimAt(const std::filesystem::path& file) {
    file_ = file;
    listAims();
    aim_->setCurrentIndex(aim_->count() - 1);
    refresh();
}

QString MatchPage::nothingText() const {
    const QString nothing = MeasurePage::nothingText();
    return nothing.isEmpty() && aims_.empty()
               ? tr("Compare with something, take a snapshot or choose a file to match.")
               : nothing;
}

void MatchPage::startMeasuring() {
    const Material* own = document().material(document().selection().side());
    const int chosen = aim_->currentIndex();
    if (!canStart() || own == nullptr || chosen < 0) {
        return;
    }
    const Aim& aim = aims_[static_cast<std::size_t>(chosen)];
    const Material* material = materialOf(aim);
    if (material == nullptr && aim.file.empty()) {
        return;
    }
    CostSweep::Options options;
    options.programCache = programFolder();
    const MatchTask task{document().sharedCatalog(),
                         material != nullptr ? std::optional(*material) : std::nullopt,
                         aim.file,
                         *own,
                         all_->isChecked(),
                         {.error = static_cast<MatchError>(error_->currentData().toInt())},
                         costSubject(),
                         std::move(options)};
    const TakeMatches taken = [this, name = aim.name,
                               error = error_->currentText()](const ModelMatches& matches) {
        take(matches, tr("Fitted to %1, %2.").arg(name, error.toLower()));
    };
    start([task, taken](Worker::Control& control) { return fit(task, control, taken); });
}

MeasuredSubject MatchPage::subject() const {
    return subjectOfModels();
}

void MatchPage::showNumbers(bool stale) {
    const QSignalBlocker blocker(list_);
    const ModelMatches& shown = matches();
    const ModelMatch* quickest = quickestWithin(shown, within);
    const QTreeWidgetItem* held = list_->currentItem();
    const QString current = held != nullptr ? held->text(modelColumn) : QString();
    list_->setSortingEnabled(false);
    list_->clear();
    for (std::size_t i = 0; i < shown.rows.size(); ++i) {
        const ModelMatch& each = shown.rows[i];
        auto* row = new NumberRow;
        row->setText(modelColumn, each.isStopped ? tr("%1 (stopped)").arg(asText(each.label))
                                                 : asText(each.label));
        row->setData(modelColumn, matchRole, int(i));
        row->setToolTip(modelColumn,
                        (each.isStopped
                             ? tr("%1, as far as its fit had come when it was stopped. Enter or a "
                                  "double click gives the object these values")
                             : tr("%1. Enter or a double click gives the object these values"))
                            .arg(asText(each.label)));
        row->setNumber(errorColumn, numberLocale().toString(each.error, 'f', 5), each.error);
        row->setNumber(relativeColumn,
                       tr("%1 %").arg(numberLocale().toString(100.0 * each.relative, 'f', 2)),
                       each.relative);
        row->setNumber(timeColumn,
                       each.nanoseconds ? numberLocale().toString(*each.nanoseconds, 'f', 1)
                                        : QStringLiteral("–"),
                       each.nanoseconds.value_or(1e30));
        for (int column = 0; column <= timeColumn; ++column) {
            QFont font = row->font(column);
            font.setBold(&each == quickest);
            row->setFont(column, font);
            if (stale || each.isStopped) {
                row->setForeground(column, palette().placeholderText());
            }
        }
        if (&each == quickest) {
            row->setToolTip(timeColumn, tr("The quickest model within 2 %"));
        }
        list_->addTopLevelItem(row);
        if (row->text(modelColumn) == current) {
            list_->setCurrentItem(row);
        }
    }
    list_->setSortingEnabled(true);
    widenColumns(*list_, modelColumn); // its words say which fit was stopped
    plot_->setMatches(shown, within, stale);
    plot_->setVisible(std::ranges::any_of(
        shown.rows, [](const ModelMatch& match) { return match.nanoseconds.has_value(); }));
}

/// Makes the row of a match the current one.
void MatchPage::select(int match) {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = list_->topLevelItem(i);
        if (row->data(modelColumn, matchRole).toInt() == match) {
            list_->setCurrentItem(row);
            list_->setFocus();
        }
    }
}

QByteArray MatchPage::bytesFor(const QString& ending) const {
    return QByteArray::fromStdString(ending == "csv" ? matchesCsv(matches())
                                                     : writeJson(matchesJson(matches())));
}

void MatchPage::apply(int row) {
    const ModelMatches& all = matches();
    if (row < 0 || static_cast<std::size_t>(row) >= all.rows.size()) {
        return;
    }
    const ModelMatch& match = all.rows[static_cast<std::size_t>(row)];
    document().replaceMaterial(document().selection().side(), match.material,
                               tr("Match by %1").arg(asText(match.label)));
}

} // namespace patina
