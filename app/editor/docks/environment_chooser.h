// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>

#include "docks/block_chooser.h"

namespace patina {

class Session;
class ThumbnailMaker;

/// A list of all environments with a small picture of each: the blocks, and below them the pictures
/// of files that scenes were lit with before. A panorama that is dropped on it joins the list.
class EnvironmentChooser : public BlockChooser {
    Q_OBJECT

  public:
    EnvironmentChooser(Document& document, Session& session, ThumbnailMaker& thumbnails,
                       QWidget* parent = nullptr);

    /// Shows what the document has: a block, or a picture of the list.
    void showCurrent();

    /// A scene was lit with this picture.
    void add(const QString& file);

    void showPopup() override;

  Q_SIGNALS:
    void pictureChosen(QString file);

  protected:
    void fill() override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void addFiles();
    void wishPictures();
    void wishPicture(int index);
    void take(const QString& name, const QImage& picture);

    Session& session_;
    ThumbnailMaker& thumbnails_;
    QHash<QString, QIcon> pictures_; ///< by what an item has as its data
    QSet<QString> wished_;
};

} // namespace patina
