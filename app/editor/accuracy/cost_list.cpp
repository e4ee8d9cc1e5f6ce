// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/cost_list.h"

#include <algorithm>
#include <array>

#include <QCoreApplication>
#include <QHeaderView>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>

#include "accuracy/cost_text.h"

namespace patina {
namespace {

constexpr int pointRole = Qt::UserRole;
constexpr int sortRole = Qt::UserRole + 1;
constexpr int markSize = 12;

enum Column { Way, Time, Ratio, P99, Mean, Rms, Worst, Steps, Perceived, Columns };
constexpr std::array<int, Columns> widths{170, 66, 104, 66, 66, 66, 66, 66, 66};

/// Sorts by numbers, not by how they are written.
class CostRow : public QTreeWidgetItem {
  public:
    bool operator<(const QTreeWidgetItem& other) const override {
        const int column = treeWidget() != nullptr ? treeWidget()->sortColumn() : 0;
        return column == Way ? text(Way).localeAwareCompare(other.text(Way)) < 0
                             : data(column, sortRole).toDouble() <
                                   other.data(column, sortRole).toDouble();
    }
};

void set(QTreeWidgetItem& row, Column column, const QString& text, double number) {
    row.setText(column, text);
    row.setData(column, sortRole, number);
    row.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

/// As in the chart: a disc on the front, a circle elsewhere, and one round the current point.
QIcon markOf(bool onFront, bool isCurrent, const QPalette& palette) {
    QPixmap pixmap(2 * markSize, 2 * markSize);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(0.5 * markSize, 0.5 * markSize);
    const QColor color = onFront ? palette.color(QPalette::Highlight)
                                 : palette.color(QPalette::PlaceholderText);
    painter.setPen(QPen(color, 1.2));
    painter.setBrush(onFront ? QBrush(color) : QBrush(Qt::NoBrush));
    painter.drawEllipse(middle, 2.6, 2.6);
    if (isCurrent) {
        painter.setPen(QPen(palette.color(QPalette::Text), 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(middle, 5.2, 5.2);
    }
    return QIcon(pixmap);
}

/// A busy machine may leave an interval that says nothing.
QString ratioText(const MedianInterval& ratio) {
    if (ratio.upper - ratio.lower > 2.0 * ratio.median) {
        return QCoreApplication::translate("CostList", "%1, not settled")
            .arg(digitsText(ratio.median));
    }
    return QStringLiteral("%1 ± %2").arg(digitsText(ratio.median),
                                         digitsText(0.5 * (ratio.upper - ratio.lower)));
}

void fillRow(QTreeWidgetItem& row, const CostPoint& point, const CostChart& chart) {
    const FrameError& error = point.error;
    row.setText(Way, wayName(point, chart));
    row.setToolTip(Way, wayDescription(point, chart));
    set(row, Time, digitsText(point.cost.nanosecondsPerPixel), point.cost.nanosecondsPerPixel);
    set(row, Ratio, ratioText(point.cost.ratio), point.cost.ratio.median);
    row.setToolTip(Ratio, CostList::tr("Between %1 and %2 with a probability of 95 %, by %3 pairs "
                                       "of frames")
                              .arg(digitsText(point.cost.ratio.lower),
                                   digitsText(point.cost.ratio.upper))
                              .arg(point.cost.runs));
    set(row, P99, shareText(error.p99), error.p99);
    set(row, Mean, shareText(error.mean), error.mean);
    set(row, Rms, shareText(error.rms), error.rms);
    set(row, Worst, shareText(error.max), error.max);
    set(row, Steps, shareText(error.stepShare), error.stepShare);
    set(row, Perceived, digitsText(error.flip), error.flip);
}

void nameColumns(QTreeWidget& list) {
    list.setHeaderLabels({CostList::tr("Way to compute it"), CostList::tr("ns/pixel"),
                          CostList::tr("Of exact time"), CostList::tr("Error"),
                          CostList::tr("Mean"), CostList::tr("RMS"), CostList::tr("Worst"),
                          CostList::tr("8 bit"), CostList::tr("FLIP")});
    QTreeWidgetItem& head = *list.headerItem();
    head.setToolTip(Way, CostList::tr("A disc: nothing is both faster and more accurate. A ring: "
                                      "what the material has now"));
    head.setToolTip(Time, CostList::tr("Nanoseconds for each pixel that shows the material"));
    head.setToolTip(Ratio, CostList::tr("Time beside that of the exact way"));
    head.setToolTip(P99, CostList::tr("Relative error that 99 of 100 pixels keep"));
    head.setToolTip(Mean, CostList::tr("Mean relative error of the pixels"));
    head.setToolTip(Rms, CostList::tr("Root mean square of the relative errors"));
    head.setToolTip(Worst, CostList::tr("Relative error of the worst pixel"));
    head.setToolTip(Steps, CostList::tr("Share of the pixels that are at least one step of 8 bits "
                                        "too bright or too dark on the screen"));
    head.setToolTip(Perceived, CostList::tr("How different the pictures look, 0 to 1 (FLIP)"));
}

} // namespace

CostList::CostList(QWidget* parent) : QTreeWidget(parent) {
    setAccessibleName(tr("Ways to compute the material"));
    nameColumns(*this);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(false);
    for (std::size_t i = 0; i < widths.size(); ++i) {
        setColumnWidth(static_cast<int>(i), widths[i]);
    }
    setSortingEnabled(true);
    sortByColumn(Time, Qt::AscendingOrder);
    connect(this, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
        Q_EMIT picked(row->data(Way, pointRole).toInt());
    });
    connect(this, &QTreeWidget::currentItemChanged, this,
            [this] { Q_EMIT selectionMoved(selected()); });
}

void CostList::setChart(const CostChart& chart, const ChosenLevels& current, bool stale) {
    const QSignalBlocker blocker(this);
    const int kept = selected();
    const int scrolled = verticalScrollBar()->value();
    const std::vector<std::size_t> front = costFront(chart.points);
    setSortingEnabled(false);
    clear();
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        const CostPoint& point = chart.points[i];
        auto* row = new CostRow;
        row->setData(Way, pointRole, static_cast<int>(i));
        fillRow(*row, point, chart);
        row->setIcon(Way, markOf(std::ranges::find(front, i) != front.end(),
                                 !stale && point.levels == current, palette()));
        for (int column = 0; stale && column < Columns; ++column) {
            row->setForeground(column, palette().placeholderText());
        }
        addTopLevelItem(row);
    }
    setSortingEnabled(true);
    select(kept);
    verticalScrollBar()->setValue(scrolled);
}

int CostList::selected() const {
    return currentItem() != nullptr ? currentItem()->data(Way, pointRole).toInt() : -1;
}

void CostList::select(int point) {
    const QSignalBlocker blocker(this);
    setCurrentItem(rowOf(point));
}

QTreeWidgetItem* CostList::rowOf(int point) const {
    for (int i = 0; i < topLevelItemCount(); ++i) {
        if (topLevelItem(i)->data(Way, pointRole).toInt() == point) {
            return topLevelItem(i);
        }
    }
    return nullptr;
}

} // namespace patina
