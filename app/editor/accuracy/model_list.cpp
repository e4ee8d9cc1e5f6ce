// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/model_list.h"

#include <cmath>
#include <utility>

#include <QHeaderView>
#include <QScrollBar>
#include <QSignalBlocker>

#include "accuracy/cost_text.h"
#include "accuracy/number_row.h"
#include "docks/prediction_text.h"
#include "measure/lobe/lobe_model.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

constexpr int modelRole = Qt::UserRole;

enum Column {
    Model,
    Ratio,
    Time,
    Total,
    Sums,
    Roots,
    Images,
    Branches,
    Memory,
    Cycles,
    Loss,
    EnergyClaim,
    ReciprocityClaim,
    ValueCount,
    Columns
};
constexpr int modelWidth = 170;

/// Rounds before writing, so that a loss near zero is not shown as "-0.0".
QString lossText(const std::optional<double>& loss) {
    return loss ? ModelList::tr("%1 %").arg(
                      numberLocale().toString(std::round(1000.0 * *loss) / 10.0 + 0.0, 'f', 1))
                : QStringLiteral("–");
}

void fillCounts(NumberRow& row, const std::optional<InstructionCount>& count) {
    row.setNumber(Total, countText(count), countOf(count));
    row.setToolTip(Total, kindsText(count));
    if (!count) {
        return;
    }
    const std::pair<Column, int> kinds[] = {{Sums, count->arithmetic},
                                            {Roots, count->transcendental},
                                            {Images, count->texture},
                                            {Branches, count->branch},
                                            {Memory, count->memory}};
    for (const auto& [column, number] : kinds) {
        row.setNumber(column, numberLocale().toString(number), number);
    }
}

void fillRow(NumberRow& row, const ModelCost& each, const GpuFamily& family) {
    row.setText(Model, QString::fromStdString(each.label));
    row.setData(Model, modelRole, QString::fromStdString(each.model));
    row.setToolTip(Model, ModelList::tr("%1. Enter or a double click gives the selected object "
                                        "this model")
                              .arg(row.text(Model)));
    row.setNumber(Ratio, costRatioText(each.cost, each.bound), each.cost.ratio.median);
    row.setToolTip(Ratio, ModelList::tr("%1. In this run: what else the machine does may give "
                                        "another run other times")
                              .arg(ratioNote(each.cost, each.bound)));
    row.setNumber(Time, perPixelText(each.cost, true), each.cost.nanosecondsPerPixel);
    fillCounts(row, each.instructions);
    row.setNumber(Loss, lossText(each.albedoLoss), each.albedoLoss.value_or(2.0));
    row.setNumber(Cycles, predictedCyclesText(each.predicted, family),
                  predictedCycles(each.predicted, family));
    row.setToolTip(Cycles, predictionNote(each.predicted, family));
}

QString claimText(const Block& model, std::string_view claim) {
    return model.hasClaim(claim) ? ModelList::tr("yes") : ModelList::tr("no");
}

/// Says what a model is by its descriptor: its formula and where it is from with its name.
void fillModel(NumberRow& row, const Block& model) {
    row.setToolTip(Model,
                   QStringLiteral("<p><b>%1</b></p><p>%2</p><p>%3</p><p>%4</p>")
                       .arg(row.text(Model).toHtmlEscaped(), asText(model.doc).toHtmlEscaped(),
                            asText(model.source).toHtmlEscaped(),
                            ModelList::tr("Enter or a double click gives the selected "
                                          "object this model.")));
    if (const std::string why = whyNoReflectance(model); !why.empty()) {
        row.setNumber(Loss, QString(), 2.0);
        row.setToolTip(Loss, asText(why));
    }
    row.setText(EnergyClaim, claimText(model, "energy_conserving"));
    row.setText(ReciprocityClaim, claimText(model, "reciprocal"));
    row.setNumber(ValueCount, wholeText(model.parameters.size()), double(model.parameters.size()));
}

void nameColumns(QTreeWidget& list) {
    list.setHeaderLabels({ModelList::tr("Model"), ModelList::tr("Of quickest"),
                          ModelList::tr("ns/pixel"), ModelList::tr("Instructions"),
                          ModelList::tr("Sums"), ModelList::tr("Roots"), ModelList::tr("Images"),
                          ModelList::tr("Branches"), ModelList::tr("Memory"), QString(),
                          ModelList::tr("Light lost"), ModelList::tr("Keeps energy"),
                          ModelList::tr("Reciprocal"), ModelList::tr("Values")});
    QTreeWidgetItem& head = *list.headerItem();
    head.setToolTip(Ratio, ModelList::tr("Time beside that of the quickest model; <: nobody can "
                                         "tell it from none. > and –: nobody can tell the "
                                         "quickest one's from none"));
    head.setToolTip(Time, ModelList::tr("Nanoseconds for each pixel that shows the object; <: no "
                                        "more than that, nobody can tell it from none"));
    head.setToolTip(Total, ModelList::tr("Instructions of the whole program, lights included; the "
                                         "same on every machine"));
    head.setToolTip(Sums, ModelList::tr("Sums, products, comparisons, choices"));
    head.setToolTip(Roots, ModelList::tr("Divisions, roots, powers, logarithms, angles"));
    head.setToolTip(Images, ModelList::tr("Looks into images"));
    head.setToolTip(Branches, ModelList::tr("Where the way depends on a number"));
    head.setToolTip(Memory, ModelList::tr("Loads and stores"));
    head.setToolTip(Loss, ModelList::tr("How much of an even white sky's light the model keeps, "
                                        "its colours as they are at first; below 0: it sends out "
                                        "more than arrives"));
    head.setToolTip(EnergyClaim, ModelList::tr("It never sends out more than arrives, whatever its "
                                               "values are"));
    head.setToolTip(ReciprocityClaim,
                    ModelList::tr("Light and viewer may change places, whatever its "
                                  "values are"));
    head.setToolTip(ValueCount, ModelList::tr("How many values there are to set"));
}

} // namespace

ModelList::ModelList(QWidget* parent) : QTreeWidget(parent), family_(&gpuFamilies().front()) {
    setAccessibleName(tr("Models and what they cost"));
    nameColumns(*this);
    setFamily(*family_);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(false);
    setSortingEnabled(true);
    sortByColumn(Ratio, Qt::AscendingOrder);
    setColumnWidth(Model, modelWidth);
    fitColumns(*this, Ratio);
    for (const Column column : {Branches, Memory}) { // the tip of all instructions has them
        hideColumn(column);
    }
    connect(this, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
        Q_EMIT picked(row->data(Model, modelRole).toString());
    });
}

void ModelList::setFamily(const GpuFamily& family) {
    family_ = &family;
    headerItem()->setText(Cycles, QString::fromStdString(family.label));
    headerItem()->setToolTip(Cycles, predictionHint(family));
}

void ModelList::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
}

void ModelList::setCosts(const std::vector<ModelCost>& costs, bool stale) {
    const QSignalBlocker blocker(this);
    const QVariant kept =
        currentItem() != nullptr ? currentItem()->data(Model, modelRole) : QVariant();
    const int scrolled = verticalScrollBar()->value();
    setSortingEnabled(false);
    clear();
    for (const ModelCost& each : costs) {
        auto* row = new NumberRow;
        fillRow(*row, each, *family_);
        const Block* model =
            catalog_ != nullptr ? catalog_->find(kinds::models, each.model) : nullptr;
        if (model != nullptr) {
            fillModel(*row, *model);
        }
        for (int column = 0; stale && column < Columns; ++column) {
            row->setForeground(column, palette().placeholderText());
        }
        addTopLevelItem(row);
        if (row->data(Model, modelRole) == kept) {
            setCurrentItem(row);
        }
    }
    setSortingEnabled(true);
    widenColumns(*this, Model);
    verticalScrollBar()->setValue(scrolled);
}

} // namespace patina
