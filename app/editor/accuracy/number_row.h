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

} // namespace patina
