// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/effects_dock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include "docks/effect_label.h"
#include "docks/panel.h"
#include "docks/settling.h"
#include "document/document.h"
#include "document/scene_edits.h"
#include "resources/environment_library.h"
#include "resources/mesh_library.h"
#include "resources/mesh_snapshot.h"
#include "resources/texture_library.h"
#include "session/session.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "viewport/compare_area.h"
#include "viewport/effect_switches.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

constexpr int effectRole = Qt::UserRole;
constexpr int progressSteps = 1000;
constexpr int settleMs = 100;
constexpr int usualRows = 14;
constexpr int minRows = 6;
constexpr int spacing = 4;

enum Column { Effect, Time, Share, Why };
constexpr std::pair<Column, int> columnWidths[] = {{Effect, 190}, {Time, 96}, {Share, 64}};

QString numberText(double number, int decimals) {
    return numberLocale().toString(number, 'f', decimals);
}

QString intervalText(const MedianInterval& interval) {
    return EffectsDock::tr("With a probability of 95 % between %1 and %2 ms")
        .arg(numberText(interval.lower, 3), numberText(interval.upper, 3));
}

} // namespace

EffectsDock::EffectsDock(const DockContext& context)
    : document_(context.document), library_(context.meshes), textures_(context.textures),
      environments_(context.environments), switches_(context.switches), views_(context.views),
      start_(textButton(tr("Measure costs"),
                        tr("Draw the scene with and without each effect and compare the times"),
                        this)),
      cancel_(textButton(tr("Cancel"), tr("Stop and keep what was measured so far"), this)),
      allOn_(textButton(tr("All on"), tr("Show every effect in the views again"), this)),
      progress_(new QProgressBar(this)), total_(new QLabel(this)), list_(new QTreeWidget(this)),
      measurement_({.name = tr("Measuring effects"), .canCancel = true}) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    layOut();
    connectParts();
    watchViews();
    updateRows();
}

/// A view of another shape, or with a camera of its own, shows other parts of the scene.
void EffectsDock::watchViews() {
    views_.installEventFilter(this);
    const auto later = [this] { settle_.start(); };
    connect(&views_, &CompareArea::linkChanged, this, later);
    connect(&views_, &CompareArea::viewAdded, this,
            [this, later](SideView* view) { connect(view, &SideView::cameraWished, this, later); });
}

void EffectsDock::layOut() {
    progress_->setRange(0, progressSteps);
    progress_->setMaximumWidth(300);
    progress_->setAccessibleName(tr("Progress of the measurement"));
    total_->setObjectName("total");
    total_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    total_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // never widens the dock
    list_->setAccessibleName(tr("Effects"));
    list_->setHeaderLabels({tr("Effect"), tr("Time"), tr("Share"), tr("Why it is in or not")});
    list_->setFrameShape(QFrame::NoFrame);
    list_->header()->setStretchLastSection(true);
    list_->setMinimumHeight((minRows + 1) * (fontMetrics().lineSpacing() + 4));
    for (const auto& [column, width] : columnWidths) {
        list_->setColumnWidth(column, width);
    }
    auto* row = new QHBoxLayout;
    row->addWidget(start_);
    row->addWidget(cancel_);
    row->addWidget(progress_);
    row->addWidget(total_, 1);
    row->addWidget(allOn_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->setSpacing(spacing);
    layout->addLayout(row);
    layout->addWidget(list_, 1);
}

void EffectsDock::connectParts() {
    connect(start_, &QToolButton::clicked, this, &EffectsDock::measure);
    connect(cancel_, &QToolButton::clicked, &measurement_, &Worker::cancel);
    connect(allOn_, &QToolButton::clicked, &switches_, &EffectSwitches::switchAllOn);
    connect(list_, &QTreeWidget::itemChanged, this, &EffectsDock::toggle);
    connect(&measurement_, &Worker::progressed, this, [this](double share) {
        progress_->setValue(static_cast<int>(std::lround(share * progressSteps)));
    });
    connect(&settle_, &QTimer::timeout, this, &EffectsDock::updateRows);
    startWhenChanged(settle_, document_, library_);
    const auto later = [this] { settle_.start(); };
    connect(&textures_, &TextureLibrary::arrived, this, later);
    connect(&environments_, &EnvironmentLibrary::loaded, this, later);
    connect(&environments_, &EnvironmentLibrary::failed, this, later);
    connect(&switches_, &EffectSwitches::changed, this, &EffectsDock::updateRows);
    onChange(document_, DocumentChange::Scene, this, [this] {
        measurement_.cancel();
        measured_.reset(); // of another document
        updateRows();
        fill();
    });
}

void EffectsDock::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    updateRows();
}

void EffectsDock::updateRows() {
    const int object = document_.selection().object();
    const Side side = document_.selection().side();
    std::vector<EffectRow> rows;
    if (object >= 0) {
        std::optional<Scene> turned;
        const Camera& shown = views_.active().viewport().camera();
        if (shown != document_.scene(side).camera) {
            turned = document_.scene(side);
            turned->camera = shown;
        }
        rows = objectRows(
            turned ? *turned : document_.scene(side), static_cast<std::size_t>(object),
            document_.catalog(), [this](const Object& each) { return library_.view(each); },
            images(), aspect());
    }
    const bool isShown =
        rows == rows_ && shownOff_ == switches_.off() && costsAreFresh_ == !isStale();
    if ((isVisible() && !isShown) || rows_.empty()) {
        rows_ = std::move(rows);
        fill();
    }
    showState();
}

/// What the views have of the images now; none is read for the list.
KnownImages EffectsDock::images() const {
    return {textures_.snapshot(),
            environments_.isMissing(environmentPicture(document_, document_.selection().side()))};
}

double EffectsDock::aspect() const {
    const Viewport& view = views_.active().viewport();
    return double(view.width()) / std::max(view.height(), 1);
}

bool EffectsDock::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        settle_.start();
    }
    return QWidget::eventFilter(watched, event);
}

/// The current row stays, and the place where the list is scrolled to.
void EffectsDock::fill() {
    const QSignalBlocker blocker(list_);
    const int scrolled = list_->verticalScrollBar()->value();
    shownOff_ = switches_.off();
    const QString current = list_->currentItem()
                                ? list_->currentItem()->data(Effect, effectRole).toString()
                                : QString();
    costsAreFresh_ = !isStale();
    list_->clear();
    for (const EffectRow& row : rows_) {
        QTreeWidgetItem* parent = parentOf(row);
        auto* item = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(list_);
        fillRow(item, row);
        if (item->data(Effect, effectRole).toString() == current) {
            list_->setCurrentItem(item);
        }
    }
    list_->expandAll();
    if (list_->currentItem() == nullptr && list_->topLevelItemCount() > 0) {
        list_->setCurrentItem(list_->topLevelItem(0));
    }
    list_->verticalScrollBar()->setValue(scrolled);
}

QTreeWidgetItem* EffectsDock::parentOf(const EffectRow& row) const {
    for (QTreeWidgetItemIterator it(list_); *it && !row.within.empty(); ++it) {
        if ((*it)->data(Effect, effectRole).toString() == asText(row.within)) {
            return *it;
        }
    }
    return nullptr;
}

/// So many rows of the list that most scenes show without scrolling.
QSize EffectsDock::sizeHint() const {
    const int rowHeight = fontMetrics().lineSpacing() + 4;
    return {640, (usualRows + 1) * rowHeight + start_->sizeHint().height() + 3 * spacing};
}

void EffectsDock::fillRow(QTreeWidgetItem* item, const EffectRow& row) {
    const bool off = switches_.isOff(row.line.effect);
    const QString label = labelOf(row.line.effect);
    item->setText(Effect, row.in ? label : tr("not in: %1").arg(label));
    item->setToolTip(Effect, label);
    item->setData(Effect, effectRole, asText(row.line.effect));
    const QString why =
        off ? tr("Switched off in the views. %1").arg(asText(row.line.reason)) : whyOf(row);
    item->setText(Why, why);
    item->setToolTip(Why, why);
    for (const Column column : {Time, Share}) {
        item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    item->setFlags(item->flags().setFlag(Qt::ItemIsUserCheckable, row.removable || off));
    if (row.removable || off) {
        item->setCheckState(Effect, off ? Qt::Unchecked : Qt::Checked);
        item->setToolTip(Effect, tr("%1\nUntick it to see the picture without it").arg(label));
    }
    if (!row.in) {
        for (const Column column : {Effect, Why}) {
            item->setForeground(column, palette().placeholderText());
        }
    }
    fillCost(item, row);
}

QString EffectsDock::labelOf(const std::string& effect) const {
    const Side side = document_.selection().side();
    return effectLabel(effect, document_.material(side), document_.scene(side),
                       document_.catalog());
}

/// A row without a switch says why it has none: the model calls what fills its slots.
QString EffectsDock::whyOf(const EffectRow& row) const {
    QString why = asText(row.line.reason);
    if (!row.in || row.removable) {
        return why;
    }
    return row.within.empty() ? tr("%1 It cannot be switched off.").arg(why)
                              : tr("%1 It goes only with %2.").arg(why, labelOf(row.within));
}

void EffectsDock::fillCost(QTreeWidgetItem* item, const EffectRow& row) {
    const bool isOfObject = measured_ && measured_->object == document_.selection().object();
    const EffectCost* cost = isOfObject && row.in ? measured_->costs.of(row.line.effect) : nullptr;
    if (cost == nullptr) {
        return;
    }
    for (const Column column : {Time, Share}) {
        item->setForeground(column,
                            costsAreFresh_ ? palette().text() : palette().placeholderText());
    }
    const double frame = measured_->costs.frame.median;
    const double share = frame > 0.0 ? 100.0 * cost->milliseconds.median / frame : 0.0;
    const QString time = cost->belowNoise()
                             ? tr("below noise")
                             : tr("%1 ms").arg(numberText(cost->milliseconds.median, 3));
    item->setText(Time, cost->isSure() ? time : tr("%1 !").arg(time));
    item->setText(Share, cost->belowNoise() ? QString() : tr("%1 %").arg(numberText(share, 1)));
    item->setToolTip(
        Time, cost->isSure() ? intervalText(cost->milliseconds)
                             : tr("By too few pairs of frames to be certain: %1").arg(cost->pairs));
}

void EffectsDock::toggle(QTreeWidgetItem* item) {
    const std::string effect = item->data(Effect, effectRole).toString().toStdString();
    const bool off = item->checkState(Effect) == Qt::Unchecked;
    // The list is filled anew because of this, which must not be while it tells of the item.
    QMetaObject::invokeMethod(
        this, [this, effect, off] { switches_.setOff(effect, off); }, Qt::QueuedConnection);
}

void EffectsDock::measure() {
    if (isMeasuring() || document_.selection().object() < 0) {
        return;
    }
    updateRows();
    const Scene& scene = document_.scene(document_.selection().side());
    measured_ = Measured{scene, document_.selection().object(), document_.selection().side(),
                         KnownBlocks(document_.sharedCatalog(), scene)};
    progress_->setValue(0);
    const EffectCostMeter::Subject subject{
        scene,
        scene.camera,
        meshSnapshot(scene, library_),
        rows_,
        measured_->blocks.catalog(),
        images().textures,
        environments_.image(environmentPicture(document_, document_.selection().side()))};
    measurement_.ask([this, subject](Worker::Control& control) { return meter(subject, control); },
                     [this](const MeasureEnd& end) { finish(end); });
    fill();
    showState();
}

/// In the worker's thread.
MeasureEnd EffectsDock::meter(const EffectCostMeter::Subject& subject, Worker::Control& control) {
    if (const Result<void> opened = control.openContext(); !opened) {
        return endOf(false, {opened.error()});
    }
    EffectCostMeter::Options options;
    options.programCache = programFolder();
    options.mayShrink = true;
    const auto meter = EffectCostMeter::create(subject, options);
    if (!meter) {
        return endOf(false, {meter.error()});
    }
    while (!(*meter)->finished() && !control.isCancelled()) {
        (*meter)->step();
        control.tell((*meter)->progress());
    }
    control.show([this, costs = (*meter)->costs()] {
        if (measured_) {
            measured_->costs = costs;
        }
    });
    return endOf((*meter)->finished(), (*meter)->costs().problems);
}

void EffectsDock::finish(const MeasureEnd& end) {
    if (measured_) {
        measured_->end = end;
    }
    fill();
    showState();
}

/// The costs are of another scene or object than the one that is shown.
bool EffectsDock::isStale() const {
    return !measured_ || measured_->object != document_.selection().object() ||
           !measured_->blocks.areIn(document_.sharedCatalog()) ||
           !(measured_->scene == document_.scene(document_.selection().side()));
}

QString EffectsDock::whyStale() const {
    const bool hasSameObjects = measured_->scene.objects.size() ==
                                document_.scene(document_.selection().side()).objects.size();
    if (hasSameObjects && measured_->object != document_.selection().object()) {
        return tr("Out of date: the costs were measured of another object.");
    }
    if (hasSameObjects && measured_->side != document_.selection().side()) {
        return tr("Out of date: the costs were measured of the other side.");
    }
    return tr("Out of date: the scene has changed since the costs were measured.");
}

QString EffectsDock::totalText() const {
    const EffectCosts& costs = measured_->costs;
    const double sum = sumOf(costs, rows_);
    const QString text =
        tr("%1 ms a frame: effects %2 ms, the rest %3 ms. %4 × %5 pixels, %6.")
            .arg(numberText(costs.frame.median, 2), numberText(sum, 2), numberText(costs.rest, 2))
            .arg(costs.size.x)
            .arg(costs.size.y)
            .arg(asText(costs.method));
    return measured_->end.value_or(false) && costs.secondsNeeded > 0.0
               ? tr("%1 Frames are slow: ! has too few to be certain.").arg(text)
               : text;
}

void EffectsDock::showState() {
    const bool running = isMeasuring();
    start_->setEnabled(!running && document_.selection().object() >= 0);
    cancel_->setVisible(running);
    progress_->setVisible(running);
    allOn_->setEnabled(!switches_.off().empty());
    if (running) {
        total_->setText(tr("Measuring …"));
    } else if (!measured_) {
        total_->setText(tr("Costs are not measured yet."));
    } else if (!measured_->end) {
        total_->setText(tr("Could not be measured: %1").arg(problemText(measured_->end)));
    } else if (isStale()) {
        total_->setText(whyStale());
    } else {
        total_->setText(measured_->end.value_or(false)
                            ? totalText()
                            : tr("Stopped. So far: %1").arg(totalText()));
    }
    total_->setToolTip(total_->text());
}

} // namespace patina
