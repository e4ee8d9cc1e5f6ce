// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QImage>
#include <QListWidget>
#include <QSet>

namespace patina {

/// Shows named images in a grid that fits its columns to its width. An item has a key, and is
/// chosen with a click or Enter.
class PictureGrid : public QListWidget {
    Q_OBJECT

  public:
    explicit PictureGrid(int pictureSize, QWidget* parent = nullptr);

    struct Entry {
        QString key;
        QString name;
        QString toolTip; ///< rich text
    };

    /// Replaces all items; keeps the images of known keys, the current item and the scroll
    /// position.
    void setEntries(const std::vector<Entry>& entries);

    /// Sets the image of a key; a null image removes it.
    void setPicture(const QString& key, const QImage& picture);

    /// Asks for all images again, as their subjects have changed; the old ones stay until then.
    void wishAnew();

    QString keyOf(const QListWidgetItem* item) const;
    QListWidgetItem* find(const QString& key) const;
    /// Returns the first item that is not hidden; null if all are.
    QListWidgetItem* firstShown() const;

  Q_SIGNALS:
    /// Is emitted on a click or Enter, even on the current item; never for a hidden one.
    void chosen(QListWidgetItem* item);
    /// Is emitted when an item comes into view, once per item after setEntries() and wishAnew().
    void pictureWished(const QString& key);

  protected:
    void paintEvent(QPaintEvent* event) override;
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                         const QEvent* event) const override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void fitColumns();
    void wishPictures();
    QPixmap emptyPicture() const;

    int pictureSize_;
    QHash<QString, QIcon> pictures_;
    QSet<QString> wished_;
};

} // namespace patina
