// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"
#include "document/document_state.h"

class QLabel;
class QLineEdit;
class QListWidgetItem;

namespace patina {

class PictureGrid;
struct PresetEntry;

/// The presets that ship and the user's own, with search. A click puts one on the active side, and
/// so does Enter, also in the search; dragging puts it where it is dropped.
class PresetsDock : public QWidget {
    Q_OBJECT

  public:
    explicit PresetsDock(const DockContext& context);

  private:
    void fill();
    void askForPicture(const QString& file);
    void applyFilter();
    void chooseAShownOne();
    void showMenu(const QPoint& place);
    void apply(const QListWidgetItem* item, Side side);
    void moveToTrash(const QString& file);

    Document& document_;
    FileActions& files_;
    PresetLibrary& presets_;
    ThumbnailMaker& thumbnails_;
    QLineEdit* search_;
    QLabel* hint_;
    PictureGrid* grid_;
};

/// Tells whether every word of a search occurs in a preset's name, description, tags or model.
bool matches(const PresetEntry& entry, const QString& modelLabel, const QString& search);

} // namespace patina
