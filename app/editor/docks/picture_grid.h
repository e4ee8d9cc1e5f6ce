// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QImage>
#include <QListWidget>
#include <QSet>

namespace patina {

/// A grid of named pictures that fits its columns to its width. An item has a key, and is chosen by
/// a click or Enter.
class PictureGrid : public QListWidget {
    Q_OBJECT

  public:
    explicit PictureGrid(int pictureSize, QWidget* parent = nullptr);

    struct Entry {
        QString key;
        QString name;
        QString toolTip; ///< rich text
    };

    /// Replaces all items; pictures that are known by key stay, and so does what is in sight.
    void setEntries(const std::vector<Entry>& entries);

    /// A null picture takes the one that is there away.
    void setPicture(const QString& key, const QImage& picture);

    /// What the pictures are of has changed; they stay until there are new ones.
    void wishAnew();

    QString keyOf(const QListWidgetItem* item) const;
    QListWidgetItem* find(const QString& key) const;
    /// The first item that is not hidden; null where all are.
    QListWidgetItem* firstShown() const;

  Q_SIGNALS:
    /// By a click or Enter, also where it is the current one already; never one that is hidden.
    void chosen(QListWidgetItem* item);
    /// An item without a picture of its own came into sight; once per item after
    /// setEntries() and wishAnew().
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
