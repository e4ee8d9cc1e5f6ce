// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

#include "sheets/cell_table.h"

namespace patina {

/// Shows the cells of a sheet with the labels of its axes, as large as they were drawn or as small
/// as it takes to have the sheet in sight. A click on a cell, or Enter, chooses it.
class SheetGrid : public QTableView {
    Q_OBJECT

  public:
    explicit SheetGrid(QWidget* parent = nullptr);

    CellTable& table() { return *table_; }

    /// Lays the cells out anew where there is another sheet.
    void fit();

    QSize sizeHint() const override;

    /// Returns where the cells that are in sight stand in the grid, in pixels.
    QRect cells() const;

  Q_SIGNALS:
    void fitted(); ///< cells() may be elsewhere
    void chosen(const QModelIndex& cell);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                         const QEvent* event) const override;

  private:
    int cellSide() const;

    CellTable* table_;
};

} // namespace patina
