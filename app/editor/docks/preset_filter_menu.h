// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

#include "library/preset_query.h"

namespace patina {

class PresetLibrary;

/// Chooses which presets are shown, apart from the search: by model, tag, folder, favourites and
/// recent ones; and adds and removes folders. It is filled when it opens.
class PresetFilterMenu : public QMenu {
    Q_OBJECT

  public:
    PresetFilterMenu(PresetLibrary& presets, QWidget* parent = nullptr);

    const PresetFilter& filter() const { return filter_; }
    /// What it leaves, in a few words: "Metal · Favourites".
    QString summary() const;
    void clearFilter();
    /// Adds a folder to the library.
    void askForFolder();

  Q_SIGNALS:
    void filterChanged();

  private:
    void fill();
    void fillModels(QMenu& menu);
    void fillTags(QMenu& menu);
    void fillFolders(QMenu& menu);
    void addChoice(QMenu& menu, const QString& text, QString PresetFilter::*field,
                   const QString& value);
    void addSwitch(const QString& text, bool PresetFilter::*field);

    PresetLibrary& presets_;
    PresetFilter filter_;
};

} // namespace patina
