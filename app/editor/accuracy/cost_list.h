// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>

#include "measure/cost/cost_chart.h"

namespace patina {

/// Shows the points of a chart as a table that can be sorted by every number. Enter or a double
/// click picks a row.
class CostList : public QTreeWidget {
    Q_OBJECT

  public:
    explicit CostList(QWidget* parent = nullptr);

    /// Shows the points. `current` are the levels chosen now; `stale` says that the points were
    /// measured before a change.
    void setChart(const CostChart& chart, const ChosenLevels& current, bool stale);

    /// Returns the point of the current row; -1 if there is none.
    int selected() const;
    void select(int point);

  Q_SIGNALS:
    void picked(int point);
    void selectionMoved(int point); ///< is emitted when the artist moves it, not by select()

  private:
    QTreeWidgetItem* rowOf(int point) const;
};

} // namespace patina
