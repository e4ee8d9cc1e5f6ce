// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QIcon>
#include <QMenu>

namespace patina {

class Document;
class ThumbnailMaker;

/// Lists the scenes that ship by name and picture; choosing one lights the document's objects as in
/// that scene. Pictures come while the menu is open.
class LightingMenu : public QMenu {
    Q_OBJECT

  public:
    LightingMenu(Document& document, ThumbnailMaker& thumbnails, QWidget* parent = nullptr);

  private:
    void fill();
    void show(const QString& name, const QImage& picture);

    Document& document_;
    ThumbnailMaker& thumbnails_;
    /// Is keyed by the names under which pictures were asked for.
    std::map<QString, QIcon> pictures_;
};

} // namespace patina
