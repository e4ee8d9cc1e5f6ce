// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/cost_list.h"

#include <QHeaderView>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>

#include "accuracy/cost_text.h"
#include "accuracy/number_row.h"

namespace patina {
namespace {

constexpr int pointRole = Qt::UserRole;
constexpr int markSize = 12;

enum Column { Setting, Time, P99, Ratio, Mean, Rms, Worst, Steps, Perceived, Count, Columns };
constexpr int settingWidth = 244;

struct MarkColors {
    QColor front;
    QColor other;
    QColor ring;
};

/// Draws the same mark as the chart: a disc on the front, a circle elsewhere, in the front's colour
/// for a tie, and a ring round the current point.
QPixmap markOf(Standing standing, bool isCurrent, const MarkColors& colors) {
    QPixmap pixmap(2 * markSize, 2 * markSize);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(0.5 * markSize, 0.5 * markSize);
    painter.setPen(QPen(standing == Standing::Beaten ? colors.other : colors.front, 1.2));
    painter.setBrush(standing == Standing::OnFront ? QBrush(colors.front) : QBrush(Qt::NoBrush));
    painter.drawEllipse(middle, 2.6, 2.6);
    if (isCurrent) {
        painter.setPen(QPen(colors.ring, 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(middle, 5.2, 5.2);
    }
    return pixmap;
}

/// Draws the discs of stale points as faint as their numbers. A selected row has another colour, as
/// its background is the highlight.
QIcon iconOf(Standing standing, bool isCurrent, bool stale, const QPalette& palette) {
    const QColor faint = palette.color(QPalette::PlaceholderText);
    const QColor selected = palette.color(QPalette::HighlightedText);
    QIcon icon;
    icon.addPixmap(markOf(standing, isCurrent,
                          {stale ? faint : palette.color(QPalette::Highlight), faint,
                           palette.color(QPalette::Text)}));
    icon.addPixmap(markOf(standing, isCurrent, {selected, selected, selected}), QIcon::Selected);
    return icon;
}

/// Writes "≈" before a time that cannot be told from the exact one.
QString timeText(const CostPoint& point, const CostChart& chart) {
    const QString text = costRatioText(point.cost, chart.boundOf(point));
    const bool ties = !point.isExact() && chart.boundOf(point) == RatioBound::None &&
                      tiesInTime(point, chart.points.front());
    return ties ? QStringLiteral("≈ %1").arg(text) : text;
}

void fillRow(NumberRow& row, const CostPoint& point, const CostChart& chart, Standing standing) {
    const FrameError& error = point.error;
    row.setText(Setting, settingName(point, chart));
    row.setData(Setting, SettingDelegate::partsRole,
                SettingDelegate::partsData(settingParts(point, chart)));
    const QString ties = tieText(point, chart, standing);
    row.setToolTip(Setting, ties.isEmpty() ? settingDescription(point, chart)
                                           : settingDescription(point, chart) + '\n' + ties);
    row.setNumber(Time, perPixelText(point.cost, false), point.cost.nanosecondsPerPixel);
    row.setNumber(Ratio, timeText(point, chart), point.cost.ratio.median);
    row.setToolTip(Ratio, ratioNote(point.cost, chart.boundOf(point)));
    row.setNumber(P99, shareText(error.p99), error.p99);
    row.setToolTip(P99, chart.isAgainstConverged(point) ? convergedNote(chart) : QString());
    row.setNumber(Mean, shareText(error.mean), error.mean);
    row.setNumber(Rms, shareText(error.rms), error.rms);
    row.setNumber(Worst, shareText(error.max), error.max);
    row.setNumber(Steps, shareText(error.stepShare), error.stepShare);
    row.setNumber(Perceived, digitsText(error.flip), error.flip);
    row.setNumber(Count, countText(point.instructions), countOf(point.instructions));
    row.setToolTip(Count, kindsText(point.instructions));
}

void nameColumns(QTreeWidget& list) {
    list.setHeaderLabels({CostList::tr("Setting"), CostList::tr("ns/pixel"), CostList::tr("Error"),
                          CostList::tr("Of exact time"), CostList::tr("Mean"), CostList::tr("RMS"),
                          CostList::tr("Worst"), CostList::tr("8 bit"), CostList::tr("FLIP"),
                          CostList::tr("Instructions")});
    QTreeWidgetItem& head = *list.headerItem();
    head.setToolTip(Setting, CostList::tr("A disc: nothing as accurate is as fast. A coloured "
                                          "circle: it may be so, the difference is within the "
                                          "noise. A ring: what is chosen now"));
    head.setToolTip(Time, CostList::tr("Nanoseconds for each pixel that counts; <: no more than "
                                       "that, nobody can tell it from none"));
    head.setToolTip(Ratio, CostList::tr("Time beside that of the exact way; ≈: nobody can tell it "
                                        "from that. <: nobody can tell it from none. > and –: "
                                        "nobody can tell the exact one's from none"));
    head.setToolTip(P99, CostList::tr("Relative error that 99 of 100 pixels keep"));
    head.setToolTip(Mean, CostList::tr("Mean relative error of the pixels"));
    head.setToolTip(Rms, CostList::tr("Root mean square of the relative errors"));
    head.setToolTip(Worst, CostList::tr("Relative error of the worst pixel"));
    head.setToolTip(Steps, CostList::tr("Share of the pixels that are at least one step of 8 bits "
                                        "too bright or too dark on the screen"));
    head.setToolTip(Perceived, CostList::tr("How different the pictures look, 0 to 1 (FLIP)"));
    head.setToolTip(Count, CostList::tr("Instructions of the program, the same on every machine"));
}

} // namespace

CostList::CostList(QWidget* parent) : QTreeWidget(parent) {
    setAccessibleName(tr("Ways to compute it"));
    nameColumns(*this);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(false);
    setTextElideMode(Qt::ElideMiddle); // both ends tell rows apart
    setItemDelegateForColumn(Setting, new SettingDelegate(this));
    setSortingEnabled(true);
    sortByColumn(Time, Qt::AscendingOrder);
    setColumnWidth(Setting, settingWidth);
    fitColumns(*this, Time);
    connect(this, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* row) { Q_EMIT picked(row->data(Setting, pointRole).toInt()); });
    connect(this, &QTreeWidget::currentItemChanged, this,
            [this] { Q_EMIT selectionMoved(selected()); });
}

void CostList::setChart(const CostChart& chart, const ChosenLevels& current, bool stale) {
    const QSignalBlocker blocker(this);
    const int kept = selected();
    const int scrolled = verticalScrollBar()->value();
    const std::vector<Standing> standing = standings(chart.points);
    const CostPoint* now = chart.find(current);
    setSortingEnabled(false);
    clear();
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        const CostPoint& point = chart.points[i];
        auto* row = new NumberRow;
        row->setData(Setting, pointRole, static_cast<int>(i));
        fillRow(*row, point, chart, standing[i]);
        if (stale) {
            row->setToolTip(Setting, staleText() + '\n' + row->toolTip(Setting));
        }
        row->setIcon(Setting, iconOf(standing[i], &point == now, stale, palette()));
        for (int column = 0; stale && column < Columns; ++column) {
            row->setForeground(column, palette().placeholderText());
        }
        addTopLevelItem(row);
    }
    setSortingEnabled(true);
    widenColumns(*this, Time);
    select(kept);
    verticalScrollBar()->setValue(scrolled);
}

int CostList::selected() const {
    return currentItem() != nullptr ? currentItem()->data(Setting, pointRole).toInt() : -1;
}

void CostList::select(int point) {
    const QSignalBlocker blocker(this);
    setCurrentItem(rowOf(point));
}

QTreeWidgetItem* CostList::rowOf(int point) const {
    for (int i = 0; i < topLevelItemCount(); ++i) {
        if (topLevelItem(i)->data(Setting, pointRole).toInt() == point) {
            return topLevelItem(i);
        }
    }
    return nullptr;
}

} // namespace patina
