// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidgetItem>

namespace patina {

/// Is a row that is sorted by its columns' numbers, not by how they are written. A column without a
/// number is sorted by its text.
class NumberRow : public QTreeWidgetItem {
  public:
    void setNumber(int column, const QString& text, double number);

    bool operator<(const QTreeWidgetItem& other) const override;
};

/// Makes the columns from `first` on as wide as their contents and names, and widens a column when
/// it is sorted by. Must be called once for each table.
void fitColumns(QTreeWidget& list, int first);

/// Widens the columns from `first` on to their contents; makes none narrower.
void widenColumns(QTreeWidget& list, int first);

} // namespace patina
