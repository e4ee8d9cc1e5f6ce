// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>

#include "measure/cost/cost_chart.h"

namespace patina {

/// The points of a chart as a table that can be sorted by every number. A row is asked for with
/// Enter or a double click.
class CostList : public QTreeWidget {
    Q_OBJECT

  public:
    explicit CostList(QWidget* parent = nullptr);

    /// Shows the points; `current` is what is chosen now, `stale` says that they are of
    /// something else than is on the screen.
    void setChart(const CostChart& chart, const ChosenLevels& current, bool stale);

    /// The point of the current row; -1: there is none.
    int selected() const;
    void select(int point);

  Q_SIGNALS:
    void picked(int point);
    void selectionMoved(int point); ///< by the artist, not by select()

  private:
    QTreeWidgetItem* rowOf(int point) const;
};

} // namespace patina
