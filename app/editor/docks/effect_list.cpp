// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/effect_list.h"

#include <utility>

#include <QHeaderView>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTreeWidgetItemIterator>

#include "docks/effect_label.h"
#include "docks/prediction_text.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

constexpr int effectRole = Qt::UserRole;
constexpr int minRows = 6;

enum Column { Effect, Time, Share, Why, Cycles };
constexpr std::pair<Column, int> columnWidths[] = {
    {Effect, 190}, {Time, 96}, {Share, 64}, {Cycles, 110}};

QString numberText(double number, int decimals) {
    return numberLocale().toString(number, 'f', decimals);
}

QString intervalText(const MedianInterval& interval) {
    return EffectList::tr("With a probability of 95 % between %1 and %2 ms")
        .arg(numberText(interval.lower, 3), numberText(interval.upper, 3));
}

QString effectOf(const QTreeWidgetItem* item) {
    return item == nullptr ? QString() : item->data(Effect, effectRole).toString();
}

} // namespace

EffectList::EffectList(const Document& document, EffectSwitches& switches,
                       const EffectMeasurement& measurement, QWidget* parent)
    : QTreeWidget(parent), document_(document), switches_(switches), measurement_(measurement),
      family_(&gpuFamilies().front()) {
    setAccessibleName(tr("Effects"));
    setHeaderLabels({tr("Effect"), tr("Time"), tr("Share"), tr("Why it is in or not"), QString()});
    setFamily(*family_);
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(true);
    header()->moveSection(Cycles, Why);
    setMinimumHeight(heightOf(minRows));
    for (const auto& [column, width] : columnWidths) {
        setColumnWidth(column, width);
    }
    connect(this, &QTreeWidget::itemChanged, this, &EffectList::toggle);
}

void EffectList::setFamily(const GpuFamily& family) {
    family_ = &family;
    headerItem()->setText(Cycles, tr("Cycles, %1").arg(asText(family.label)));
    headerItem()->setToolTip(Cycles, predictionHint(family));
    refresh();
}

int EffectList::heightOf(int rows) const {
    return (rows + 1) * (fontMetrics().lineSpacing() + 4);
}

bool EffectList::shows(const std::vector<EffectRow>& rows) const {
    return rows == rows_ && shownOff_ == switches_.off() &&
           costsAreFresh_ == !measurement_.isStale();
}

void EffectList::setRows(std::vector<EffectRow> rows) {
    rows_ = std::move(rows);
    refresh();
}

void EffectList::refresh() {
    const QSignalBlocker blocker(this);
    const int scrolled = verticalScrollBar()->value();
    const QString current = effectOf(currentItem());
    shownOff_ = switches_.off();
    costsAreFresh_ = !measurement_.isStale();
    clear();
    for (const EffectRow& row : rows_) {
        QTreeWidgetItem* parent = parentOf(row);
        auto* item = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(this);
        fillRow(item, row);
        if (effectOf(item) == current) {
            setCurrentItem(item);
        }
    }
    expandAll();
    if (currentItem() == nullptr && topLevelItemCount() > 0) {
        setCurrentItem(topLevelItem(0));
    }
    verticalScrollBar()->setValue(scrolled);
}

QTreeWidgetItem* EffectList::parentOf(const EffectRow& row) const {
    for (QTreeWidgetItemIterator it(const_cast<EffectList*>(this)); // NOLINT: Qt has no const one
         *it && !row.within.empty(); ++it) {
        if (effectOf(*it) == asText(row.within)) {
            return *it;
        }
    }
    return nullptr;
}

void EffectList::fillRow(QTreeWidgetItem* item, const EffectRow& row) const {
    const bool off = switches_.isOff(row.line.effect);
    const QString label = labelOf(row.line.effect);
    item->setText(Effect, row.in ? label : tr("not in: %1").arg(label));
    item->setToolTip(Effect, label);
    item->setData(Effect, effectRole, asText(row.line.effect));
    const QString why =
        off ? tr("Switched off in the views. %1").arg(asText(row.line.reason)) : reasonOf(row);
    item->setText(Why, why);
    item->setToolTip(Why, why);
    for (const Column column : {Time, Share, Cycles}) {
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
    fillPrediction(item, row);
}

void EffectList::fillCost(QTreeWidgetItem* item, const EffectRow& row) const {
    const EffectCosts* costs = measurement_.costs();
    const EffectCost* cost = costs && row.in ? costs->of(row.line.effect) : nullptr;
    if (cost == nullptr) {
        return;
    }
    for (const Column column : {Time, Share}) {
        item->setForeground(column,
                            costsAreFresh_ ? palette().text() : palette().placeholderText());
    }
    const double frame = costs->frame.median;
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

void EffectList::fillPrediction(QTreeWidgetItem* item, const EffectRow& row) const {
    const Result<PredictedEffects>* predicted = measurement_.predicted();
    if (predicted == nullptr || !row.in) {
        return;
    }
    item->setForeground(Cycles, costsAreFresh_ ? palette().text() : palette().placeholderText());
    if (!row.removable) {
        item->setText(Cycles,
                      row.within.empty() ? tr("always in") : tr("in %1").arg(labelOf(row.within)));
        item->setToolTip(Cycles, reasonOf(row));
        return;
    }
    if (!*predicted) {
        item->setText(Cycles, QStringLiteral("–"));
        item->setToolTip(Cycles, asText(predicted->error().text()));
        return;
    }
    const auto cycles = (*predicted)->cyclesOf(row.line.effect, family_->id);
    const auto instructions = (*predicted)->instructionsOf(row.line.effect, family_->id);
    if (cycles && *cycles == 0.0 && *instructions == 0) {
        item->setText(Cycles, tr("no part"));
        item->setToolTip(Cycles, tr("It is in another pass than the object's shader"));
    } else if (cycles) {
        item->setText(Cycles, numberText(*cycles, 0));
        item->setToolTip(Cycles, tr("Predicted: the object's shader has %1 instructions more with "
                                    "it. Of the whole shader:\n%2")
                                     .arg(*instructions)
                                     .arg(predictionNote((*predicted)->whole, *family_)));
    } else if (const Error* problem = (*predicted)->problemOf(row.line.effect)) {
        item->setText(Cycles, QStringLiteral("–"));
        item->setToolTip(Cycles, asText(problem->text()));
    }
}

QString EffectList::labelOf(const std::string& effect) const {
    const Side side = document_.selection().side();
    return effectLabel(effect, document_.material(side), document_.scene(side),
                       document_.catalog());
}

/// A row without a switch says why it has none: the model calls what fills its slots.
QString EffectList::reasonOf(const EffectRow& row) const {
    QString reason = asText(row.line.reason);
    if (!row.in || row.removable) {
        return reason;
    }
    return row.within.empty() ? tr("%1 It cannot be switched off.").arg(reason)
                              : tr("%1 It goes only with %2.").arg(reason, labelOf(row.within));
}

void EffectList::toggle(QTreeWidgetItem* item) {
    const std::string effect = effectOf(item).toStdString();
    const bool off = item->checkState(Effect) == Qt::Unchecked;
    // The list is filled anew because of this, which must not be while it tells of the item.
    QMetaObject::invokeMethod(
        this, [this, effect, off] { switches_.setOff(effect, off); }, Qt::QueuedConnection);
}

} // namespace patina
