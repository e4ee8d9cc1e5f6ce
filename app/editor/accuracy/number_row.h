// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidgetItem>

namespace patina {

/// A row that is sorted by the numbers of its columns, not by how they are written. A column
/// without a number is sorted by its text.
class NumberRow : public QTreeWidgetItem {
  public:
    void setNumber(int column, const QString& text, double number);

    bool operator<(const QTreeWidgetItem& other) const override;
};

/// Makes the columns from `first` on as wide as what they hold, which is at least their names, and
/// widens them where another one is sorted by. Call it once for a table.
void fitColumns(QTreeWidget& list, int first);

/// Widens the columns from `first` on to what they hold now; narrower ones stay as they are.
void widenColumns(QTreeWidget& list, int first);

} // namespace patina
