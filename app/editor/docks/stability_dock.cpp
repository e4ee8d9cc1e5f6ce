// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/stability_dock.h"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QShortcut>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "docks/panel.h"
#include "docks/stability_check.h"
#include "document/document.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

constexpr int evalLineRole = Qt::UserRole;
constexpr int progressSteps = 1000;

enum Column { What, Cases, Where, Amount };
constexpr std::pair<Column, int> columnWidths[] = {{What, 230}, {Cases, 70}, {Amount, 230}};

QString verdictOf(const StabilityOutcome& outcome) {
    const QString cases =
        StabilityDock::tr("%1 cases%2").arg(wholeText(outcome.cases), outcome.limit);
    if (!outcome.problems.isEmpty()) {
        return StabilityDock::tr("Could not be checked: %1").arg(outcome.problems.join(' '));
    }
    if (!outcome.failures.empty()) {
        return outcome.complete ? StabilityDock::tr("It breaks (%1 tried)").arg(cases)
                                : StabilityDock::tr("Stopped after %1: it breaks").arg(cases);
    }
    return outcome.complete
               ? StabilityDock::tr("Nothing breaks: %1").arg(cases)
               : StabilityDock::tr("Stopped after %1: nothing broke so far").arg(cases);
}

} // namespace

StabilityDock::StabilityDock(const DockContext& context)
    : document_(context.document),
      start_(textButton(tr("Check stability"),
                        tr("Evaluate this material wherever formulas break, with its values and at "
                           "the ends of every range"),
                        this)),
      cancel_(textButton(tr("Cancel"), tr("Stop and keep what was found so far"), this)),
      copy_(textButton(tr("Copy case"), tr("Copy the selected case as a line for `patina eval`"),
                       this)),
      progress_(new QProgressBar(this)), verdictLabel_(new QLabel(this)), remarks_(hintLabel(this)),
      list_(new QTreeWidget(this)), check_({.name = tr("Checking stability"), .canCancel = true}) {
    progress_->setRange(0, progressSteps);
    progress_->setMaximumWidth(300);
    progress_->setAccessibleName(tr("Progress of the check"));
    verdictLabel_->setObjectName("verdict");
    verdictLabel_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    remarks_->setObjectName("remarks");
    list_->setAccessibleName(tr("What breaks"));
    list_->setHeaderLabels({tr("What breaks"), tr("Cases"), tr("Where"), tr("By how much")});
    list_->setRootIsDecorated(false);
    list_->setFrameShape(QFrame::NoFrame);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(Where, QHeaderView::Stretch);
    for (const auto& [column, width] : columnWidths) {
        list_->setColumnWidth(column, width);
    }
    auto* row = new QHBoxLayout;
    row->addWidget(start_);
    row->addWidget(cancel_);
    row->addWidget(progress_);
    row->addWidget(verdictLabel_, 1);
    row->addWidget(copy_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(remarks_);
    layout->addWidget(list_, 1);
    connectParts();
    showState();
}

void StabilityDock::connectParts() {
    connect(start_, &QToolButton::clicked, this, &StabilityDock::start);
    connect(cancel_, &QToolButton::clicked, &check_, &Worker::cancel);
    connect(copy_, &QToolButton::clicked, this, &StabilityDock::copyLine);
    auto* copy = new QShortcut(QKeySequence::Copy, list_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(copy, &QShortcut::activated, this, &StabilityDock::copyLine);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, &StabilityDock::showState);
    connect(&check_, &Worker::progressed, this, &StabilityDock::showProgress);
    onChange(document_, DocumentChange::Drawn | DocumentChange::Current, this,
             &StabilityDock::showState);
}

void StabilityDock::start() {
    const Material* material = document_.material(document_.selection().side());
    if (material == nullptr || isRunning()) {
        return;
    }
    checked_ = *material;
    Scene scene;
    scene.objects.emplace_back().material = checked_;
    blocks_ = KnownBlocks(document_.sharedCatalog(), std::move(scene));
    verdict_.clear();
    list_->clear();
    remarks_->clear();
    progress_->setValue(0);
    check_.ask(
        [catalog = blocks_.catalog(), material = checked_](Worker::Control& control) {
            return checkStability(*catalog, material, control);
        },
        [this](const Result<StabilityOutcome>& checked) { showOutcome(checked); });
    showState();
}

void StabilityDock::showProgress(double share, const QString& cases) {
    progress_->setValue(static_cast<int>(std::lround(share * progressSteps)));
    verdictLabel_->setText(cases);
}

void StabilityDock::showOutcome(const Result<StabilityOutcome>& checked) {
    StabilityOutcome outcome = checked.value_or(StabilityOutcome());
    if (!checked) {
        outcome.problems << asText(checked.error().text());
    }
    verdict_ = verdictOf(outcome);
    remarks_->setText(outcome.remarks.join(' '));
    fill(outcome);
    showState();
}

void StabilityDock::fill(const StabilityOutcome& outcome) {
    for (const StabilityFailure& failure : outcome.failures) {
        auto* row = new QTreeWidgetItem(
            list_, {failure.what, wholeText(failure.count), failure.where, failure.amount});
        row->setData(What, evalLineRole, failure.evalLine);
        row->setTextAlignment(Cases, Qt::AlignRight | Qt::AlignVCenter);
        for (const Column column : {What, Where, Amount}) {
            row->setToolTip(column, row->text(column));
        }
    }
    if (list_->topLevelItemCount() > 0) {
        list_->setCurrentItem(list_->topLevelItem(0));
    }
}

/// Returns whether the result is of another material, or of other blocks, than the current ones.
bool StabilityDock::isStale() const {
    const Material* material = document_.material(document_.selection().side());
    return material == nullptr || !(*material == checked_) ||
           !blocks_.areIn(document_.sharedCatalog());
}

void StabilityDock::showState() {
    const bool running = isRunning();
    start_->setEnabled(!running && document_.material(document_.selection().side()) != nullptr);
    cancel_->setVisible(running);
    progress_->setVisible(running);
    remarks_->setVisible(!remarks_->text().isEmpty());
    copy_->setEnabled(list_->currentItem() != nullptr);
    if (running) {
        return;
    }
    const bool stale = !verdict_.isEmpty() && isStale();
    verdictLabel_->setText(
        verdict_.isEmpty() ? tr("Not checked yet.")
        : stale            ? tr("%1. Out of date: the material has changed since.").arg(verdict_)
                           : tr("%1.").arg(verdict_));
    list_->setEnabled(!stale);
}

void StabilityDock::copyLine() const {
    if (const QTreeWidgetItem* row = list_->currentItem()) {
        QApplication::clipboard()->setText(row->data(What, evalLineRole).toString());
    }
}

} // namespace patina
