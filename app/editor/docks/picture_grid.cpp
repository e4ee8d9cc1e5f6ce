// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/picture_grid.h"

#include <algorithm>

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>

#include "docks/rounded_picture.h"

namespace patina {
namespace {

constexpr int keyRole = Qt::UserRole;
constexpr int spaceBeside = 14;

} // namespace

PictureGrid::PictureGrid(int pictureSize, QWidget* parent)
    : QListWidget(parent), pictureSize_(pictureSize) {
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setWordWrap(true);
    setTextElideMode(Qt::ElideRight);
    setIconSize({pictureSize, pictureSize});
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QListWidget::itemClicked, this, &PictureGrid::chosen);
}

void PictureGrid::setEntries(const std::vector<Entry>& entries) {
    const QString current = keyOf(currentItem());
    const int inSight = verticalScrollBar()->value();
    clear();
    wished_.clear();
    const QIcon empty(emptyPicture());
    for (const Entry& entry : entries) {
        auto* item = new QListWidgetItem(entry.name, this);
        item->setData(keyRole, entry.key);
        item->setToolTip(entry.toolTip);
        item->setIcon(pictures_.value(entry.key, empty));
    }
    if (QListWidgetItem* same = find(current)) {
        setCurrentItem(same);
    }
    fitColumns();
    doItemsLayout(); // gives the scroll bar its range
    verticalScrollBar()->setValue(inSight);
}

void PictureGrid::paintEvent(QPaintEvent* event) {
    QListWidget::paintEvent(event);
    wishPictures();
}

/// Asks only for images in view: others would cost time and memory for nobody.
void PictureGrid::wishPictures() {
    for (int row = 0; row < count(); ++row) {
        const QListWidgetItem* shown = item(row);
        const QString key = keyOf(shown);
        if (!shown->isHidden() && !wished_.contains(key) &&
            visualItemRect(shown).intersects(viewport()->rect())) {
            wished_.insert(key);
            Q_EMIT pictureWished(key);
        }
    }
}

/// Makes the first item current so that the keys have a place to start; does not choose it.
void PictureGrid::focusInEvent(QFocusEvent* event) {
    if (QListWidgetItem* first = firstShown(); first && !currentItem()) {
        setCurrentItem(first, QItemSelectionModel::NoUpdate);
    }
    QListWidget::focusInEvent(event);
}

void PictureGrid::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    QListWidgetItem* current = currentItem();
    if (isEnter && current && !current->isHidden()) {
        Q_EMIT chosen(current);
        return;
    }
    QListWidget::keyPressEvent(event);
}

void PictureGrid::setPicture(const QString& key, const QImage& picture) {
    const QIcon icon = picture.isNull() ? QIcon(emptyPicture()) : rounded(picture);
    if (picture.isNull()) {
        pictures_.remove(key);
    } else {
        pictures_[key] = icon;
    }
    if (QListWidgetItem* item = find(key)) {
        item->setIcon(icon);
    }
}

void PictureGrid::wishAnew() {
    wished_.clear();
    viewport()->update();
}

QString PictureGrid::keyOf(const QListWidgetItem* item) const {
    return item ? item->data(keyRole).toString() : QString();
}

QListWidgetItem* PictureGrid::find(const QString& key) const {
    for (int row = 0; row < count(); ++row) {
        if (keyOf(item(row)) == key) {
            return item(row);
        }
    }
    return nullptr;
}

QListWidgetItem* PictureGrid::firstShown() const {
    for (int row = 0; row < count(); ++row) {
        if (!item(row)->isHidden()) {
            return item(row);
        }
    }
    return nullptr;
}

/// Selects only on a click on an item: clicks between items and drags keep the selection.
QItemSelectionModel::SelectionFlags PictureGrid::selectionCommand(const QModelIndex& index,
                                                                  const QEvent* event) const {
    const bool isDrag = event && event->type() == QEvent::MouseMove;
    return index.isValid() && !isDrag ? QListWidget::selectionCommand(index, event)
                                      : QItemSelectionModel::NoUpdate;
}

/// Keeps the current item in view when the items move to other rows.
void PictureGrid::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    fitColumns();
    if (const QListWidgetItem* chosen = currentItem()) {
        doItemsLayout(); // updates the items' places
        scrollToItem(chosen);
    }
}

void PictureGrid::changeEvent(QEvent* event) {
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fitColumns();
    }
}

/// Fits as many columns as have room, and spreads them over the whole width.
void PictureGrid::fitColumns() {
    // The view keeps room for a scroll bar that is not there yet.
    const int bar = verticalScrollBar()->isVisible() ? 0 : verticalScrollBar()->sizeHint().width();
    const int width = viewport()->width() - bar - 2;
    const int columns = std::max(1, width / (pictureSize_ + spaceBeside));
    const int height = pictureSize_ + 2 * fontMetrics().lineSpacing() + spaceBeside;
    setGridSize({std::max(width / columns, 1), height});
}

QPixmap PictureGrid::emptyPicture() const {
    QPixmap empty(pictureSize_, pictureSize_);
    empty.fill(Qt::transparent);
    QPainter painter(&empty);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Midlight));
    painter.drawRoundedRect(empty.rect(), 5, 5);
    return empty;
}

} // namespace patina
