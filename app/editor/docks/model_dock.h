// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "docks/dock_context.h"

class QListWidgetItem;

namespace patina {

class PictureGrid;

/// Shows all lighting models with an image each; a click gives one to the active material.
class ModelDock : public QWidget {
    Q_OBJECT

  public:
    explicit ModelDock(const DockContext& context);

  private:
    void fill();
    void askForPicture(const QString& id);
    void showCurrent();
    void choose(const QString& id);
    void approach(const QListWidgetItem* item);

    Document& document_;
    ThumbnailMaker& thumbnails_;
    PictureGrid* grid_;
    QTimer rest_; ///< runs out when the pointer or the keyboard rests on a model
    QString approached_;
};

} // namespace patina
