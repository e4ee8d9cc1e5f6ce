// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/number_row.h"

#include <QTreeWidget>

namespace patina {
namespace {

constexpr int sortRole = Qt::UserRole + 1;

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

} // namespace patina
