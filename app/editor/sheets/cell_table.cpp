// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/cell_table.h"

#include <algorithm>

#include "text/as_text.h"

namespace patina {

void CellTable::setSheet(const PlannedSheet& sheet) {
    const bool hasSameShape = sheet_.plan && sheet_.plan->columns() == sheet.plan->columns() &&
                              sheet_.plan->rows() == sheet.plan->rows() &&
                              sheet_.plan->isControl(sheet_.plan->rows() - 1) ==
                                  sheet.plan->isControl(sheet.plan->rows() - 1);
    if (!hasSameShape) { // else the current cell stays where it is
        beginResetModel();
        sheet_ = sheet;
        endResetModel();
        return;
    }
    sheet_ = sheet;
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    Q_EMIT headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

void CellTable::setCell(int place, const SheetCell& cell) {
    if (place < static_cast<int>(sheet_.cells.size())) {
        sheet_.cells[static_cast<std::size_t>(place)] = cell;
        const QModelIndex changed = index(place / columnCount(), place % columnCount());
        Q_EMIT dataChanged(changed, changed);
    }
}

void CellTable::markShown(const QModelIndex& shown) {
    for (int i = 0; i < static_cast<int>(sheet_.cells.size()); ++i) {
        sheet_.cells[static_cast<std::size_t>(i)].isShown =
            isControl(shown.row()) ? isControl(i / columnCount()) : i == indexOf(shown);
    }
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void CellTable::clear() {
    beginResetModel();
    sheet_ = {};
    endResetModel();
}

const SheetCell& CellTable::cell(const QModelIndex& index) const {
    return sheet_.cells[static_cast<std::size_t>(indexOf(index))];
}

int CellTable::dueCells() const {
    return static_cast<int>(std::ranges::count_if(sheet_.cells, &SheetCell::isDue));
}

QStringList CellTable::caption(const QModelIndex& index) const {
    QStringList lines;
    for (const std::string& line : captionOf(cell(index).numbers, sheet_.sheet.numbers)) {
        lines << asText(line);
    }
    return lines;
}

int CellTable::rowCount(const QModelIndex& parent) const {
    return sheet_.plan && !parent.isValid() ? sheet_.plan->rows() : 0;
}

int CellTable::columnCount(const QModelIndex& parent) const {
    return sheet_.plan && !parent.isValid() ? sheet_.plan->columns() : 0;
}

QVariant CellTable::data(const QModelIndex& index, int role) const {
    switch (role) {
    case Qt::AccessibleTextRole:
        return described(index);
    case Qt::ToolTipRole:
        return toolTipOf(index);
    default:
        return {};
    }
}

QVariant CellTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (!sheet_.plan || section < 0) {
        return {};
    }
    const bool isAcross = orientation == Qt::Horizontal;
    const bool isInside = section < (isAcross ? columnCount() : rowCount());
    if (!isInside || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
        return {};
    }
    const QString label =
        asText(isAcross ? sheet_.plan->x().steps[static_cast<std::size_t>(section)].label
                        : sheet_.plan->rowLabel(section));
    if (role == Qt::DisplayRole) {
        return label;
    }
    if (!isAcross && isControl(section)) {
        return tr("What the sheet starts from, below each column");
    }
    const auto& y = sheet_.plan->y();
    const std::string& title = isAcross ? sheet_.plan->x().title : y ? y->title : std::string();
    return tr("%1: %2").arg(asText(title), label);
}

QString CellTable::described(const QModelIndex& index) const {
    QStringList parts{asText(sheet_.plan->cellLabel(index.column(), index.row()))};
    const SheetCell& shown = cell(index);
    if (shown.isShown) {
        parts << tr("shown now");
    }
    for (const QString& line : caption(index)) {
        if (!line.isEmpty()) {
            parts << line;
        }
    }
    if (!shown.problem.isEmpty()) {
        parts << shown.problem;
    }
    return parts.join(QStringLiteral(", "));
}

QString CellTable::toolTipOf(const QModelIndex& index) const {
    const SheetCell& shown = cell(index);
    const QString what = shown.problem.isEmpty() ? shown.isShown
                                                       ? tr("This is what the view shows.")
                                                       : tr("Click to give the material this look.")
                                                 : tr("There is no such look.");
    return described(index) + '\n' + what;
}

} // namespace patina
