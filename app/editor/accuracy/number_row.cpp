// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/number_row.h"

#include <algorithm>

#include <QHeaderView>
#include <QStyle>
#include <QTreeWidget>

namespace patina {
namespace {

constexpr int sortRole = Qt::UserRole + 1;

/// Returns the width that a column's texts need, in pixels. Only the sorted column gets room for
/// the arrow: with such room in each column a table would not fit a dock.
int widthOf(const QTreeWidget& list, int column) {
    const int margin = list.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &list) + 1;
    const int between = list.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &list);
    int width = list.header()->fontMetrics().horizontalAdvance(list.headerItem()->text(column)) +
                2 * between;
    for (int i = 0; i < list.topLevelItemCount(); ++i) {
        const QTreeWidgetItem& item = *list.topLevelItem(i);
        const QVariant font = item.data(column, Qt::FontRole); // bold text is wider
        const QFontMetrics metrics =
            font.isValid() ? QFontMetrics(font.value<QFont>()) : list.fontMetrics();
        width = std::max(width, metrics.horizontalAdvance(item.text(column)) + 2 * margin);
    }
    return column == list.sortColumn()
               ? std::max(width + between, list.header()->sectionSizeHint(column))
               : width + between;
}

} // namespace

void NumberRow::setNumber(int column, const QString& text, double number) {
    setText(column, text);
    setData(column, sortRole, number);
    setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

bool NumberRow::operator<(const QTreeWidgetItem& other) const {
    const int column = treeWidget() != nullptr ? treeWidget()->sortColumn() : 0;
    const QVariant number = data(column, sortRole);
    return number.isValid() ? number.toDouble() < other.data(column, sortRole).toDouble()
                            : text(column).localeAwareCompare(other.text(column)) < 0;
}

void fitColumns(QTreeWidget& list, int first) {
    for (int column = first; column < list.columnCount(); ++column) {
        list.setColumnWidth(column, widthOf(list, column));
    }
    QObject::connect(list.header(), &QHeaderView::sortIndicatorChanged, &list,
                     [&list, first] { widenColumns(list, first); });
}

void widenColumns(QTreeWidget& list, int first) {
    for (int column = first; column < list.columnCount(); ++column) {
        list.setColumnWidth(column, std::max(list.columnWidth(column), widthOf(list, column)));
    }
}

} // namespace patina
