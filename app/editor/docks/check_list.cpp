// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/check_list.h"

#include <algorithm>

#include <QKeyEvent>
#include <QSignalBlocker>

namespace patina {
namespace {

constexpr int rowsInSight = 4;

bool isDuplicate(const QKeyEvent& key) {
    return key.key() == Qt::Key_D && key.modifiers() == Qt::ControlModifier;
}

} // namespace

CheckList::CheckList(QWidget* parent) : QListWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setUniformItemSizes(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    connect(this, &QListWidget::currentRowChanged, this, &CheckList::chosen);
    connect(this, &QListWidget::currentRowChanged, this, &CheckList::tellSelected);
    connect(this, &QListWidget::itemSelectionChanged, this, &CheckList::tellSelected);
    connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const int index = row(item);
        const Row before = rows_[static_cast<std::size_t>(index)];
        const bool on = item->checkState() == Qt::Checked;
        if (on != before.on) {
            Q_EMIT switched(index, on);
        } else if (item->text() != before.name) {
            Q_EMIT renamed(index, item->text().trimmed());
        }
    });
}

void CheckList::tellSelected() {
    std::vector<int> rows;
    for (const QModelIndex& index : selectedIndexes()) {
        rows.push_back(index.row());
    }
    if (const auto current = std::ranges::find(rows, currentRow()); current != rows.end()) {
        std::iter_swap(current, rows.end() - 1);
    }
    Q_EMIT selected(rows);
}

void CheckList::setRows(const std::vector<Row>& rows, int current, std::vector<int> selected) {
    const QSignalBlocker quiet(this);
    if (rows != rows_ || count() != static_cast<int>(rows.size())) {
        rows_ = rows;
        clear();
        for (const Row& row : rows) {
            auto* item = new QListWidgetItem(row.name, this);
            item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
            item->setCheckState(row.on ? Qt::Checked : Qt::Unchecked);
            item->setToolTip(row.detail);
        }
    }
    if (selectionMode() == SingleSelection) {
        setCurrentRow(current);
        return;
    }
    // A click may be under way, so rows in the right state are not touched.
    if (selected.empty() && current >= 0) {
        selected.push_back(current);
    }
    for (int row = 0; row < count(); ++row) {
        const bool isSelected = std::ranges::find(selected, row) != selected.end();
        if (item(row)->isSelected() != isSelected) {
            item(row)->setSelected(isSelected);
        }
    }
    if (currentRow() != current) {
        setCurrentRow(current, QItemSelectionModel::NoUpdate);
    }
}

/// Takes Ctrl+D while the list has the focus, so that the window's action with that key does not
/// run.
bool CheckList::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isDuplicate(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QListWidget::event(event);
}

void CheckList::keyPressEvent(QKeyEvent* event) {
    if (isDuplicate(*event) && currentRow() >= 0) {
        Q_EMIT duplicateWished();
        return;
    }
    if (event->key() == Qt::Key_Delete && currentRow() >= 0) {
        Q_EMIT removeWished(currentRow());
        return;
    }
    QListWidget::keyPressEvent(event);
}

/// Is the same for any number of rows, so that what is below does not move under the pointer.
QSize CheckList::sizeHint() const {
    return {160, rowsInSight * (fontMetrics().lineSpacing() + 4) + 2 * frameWidth()};
}

} // namespace patina
