// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>

#include "docks/block_chooser.h"

namespace patina {

class Session;
class ThumbnailMaker;

/// Lists all environments with a small image of each: first the blocks, then the files that scenes
/// were lit with before. A panorama that is dropped here joins the list.
class EnvironmentChooser : public BlockChooser {
    Q_OBJECT

  public:
    EnvironmentChooser(Document& document, Session& session, ThumbnailMaker& thumbnails,
                       QWidget* parent = nullptr);

    /// Selects the document's environment: its picture if that is in the list, else its block.
    void showCurrent();

    /// Puts a file that lights the scene on top of the files in the list.
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
    /// Holds small images by the data of their items: a block's id, or a path.
    QHash<QString, QIcon> pictures_;
    QSet<QString> wished_;
};

} // namespace patina
