// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QIcon>
#include <QMenu>

namespace patina {

class Document;
class ThumbnailMaker;

/// The scenes that ship, by name and picture: the document's objects are lit as in the one that is
/// chosen. Pictures come while the menu is open.
class LightingMenu : public QMenu {
    Q_OBJECT

  public:
    LightingMenu(Document& document, ThumbnailMaker& thumbnails, QWidget* parent = nullptr);

  private:
    void fill();
    void show(const QString& name, const QImage& picture);

    Document& document_;
    ThumbnailMaker& thumbnails_;
    std::map<QString, QIcon> pictures_; ///< by the names under which they were asked for
};

} // namespace patina
