// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "sheets/sheet_drawing.h"

namespace patina {

/// Holds the cells of a sheet as a table, whose headers are the steps of its axes.
class CellTable : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    void setSheet(const PlannedSheet& sheet);
    void setCell(int index, const SheetCell& cell);
    /// Marks this cell, and no other, as what the document shows.
    void markShown(const QModelIndex& index);
    void clear();

    /// Returns the plan; null while there is none.
    const std::shared_ptr<const SheetPlan>& plan() const { return sheet_.plan; }
    const Sheet& sheet() const { return sheet_.sheet; }
    const SheetCell& cell(const QModelIndex& index) const;
    int dueCells() const; ///< counts cells that are not drawn yet
    /// Returns the lines below the picture of a cell.
    QStringList caption(const QModelIndex& index) const;
    bool isControl(int row) const { return sheet_.plan && sheet_.plan->isControl(row); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    QString described(const QModelIndex& index) const;
    QString toolTipOf(const QModelIndex& index) const;
    int indexOf(const QModelIndex& index) const {
        return index.row() * columnCount() + index.column();
    }

    PlannedSheet sheet_;
};

} // namespace patina
