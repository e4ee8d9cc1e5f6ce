// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/pass_times_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "docks/panel.h"
#include "text/counted.h"
#include "text/display_number.h"

namespace patina {
namespace {

constexpr QSize passTimesSize(460, 420);

QTreeWidgetItem* rowOf(const QString& name, double milliseconds, double all) {
    const QLocale locale = numberLocale();
    const double percent = all > 0.0 ? 100.0 * milliseconds / all : 0.0;
    auto* row = new QTreeWidgetItem(
        {name, locale.toString(milliseconds, 'f', 2), locale.toString(percent, 'f', 1)});
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    return row;
}

} // namespace

PassTimesDialog::PassTimesDialog(const EffectCosts& costs, QWidget* parent) : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("passTimes");
    setWindowTitle(tr("Times of the Passes"));
    const double all = costs.ofAllPasses();
    auto* list = new QTreeWidget(this);
    list->setHeaderLabels({tr("Pass"), tr("ms"), tr("%")});
    list->setRootIsDecorated(false);
    list->setAccessibleName(tr("Times of the passes"));
    for (const PassCost& cost : costs.visiblePasses()) {
        QString name = QString::fromStdString(cost.pass);
        name[0] = name[0].toUpper();
        list->addTopLevelItem(rowOf(name, cost.milliseconds.median, all));
    }
    list->addTopLevelItem(rowOf(tr("All, waited for one by one"), all, all));
    list->header()->setStretchLastSection(false);
    list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    auto* hint = hintLabel(this);
    const int frames = costs.passes.empty() ? 0 : costs.passes.front().frames;
    hint->setText(
        tr("Medians of %1 of %2 × %3 pixels in which something has moved, so that "
           "shadow maps are drawn too. Each pass is waited for, which takes longer than "
           "the frame does otherwise: %4 ms.")
            .arg(counted(static_cast<std::size_t>(frames), tr("1 frame"), tr("%1 frames")))
            .arg(costs.size.x)
            .arg(costs.size.y)
            .arg(numberLocale().toString(costs.frame.median, 'f', 2)));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list, 1);
    layout->addWidget(hint);
    layout->addWidget(buttons);
    resize(passTimesSize);
}

} // namespace patina
