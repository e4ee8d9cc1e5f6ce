// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

#include "library/preset_query.h"

namespace patina {

class PresetLibrary;

/// Filters presets by model, tag, folder, favourites and recent ones, apart from the search; also
/// adds and removes folders. It is filled each time it opens.
class PresetFilterMenu : public QMenu {
    Q_OBJECT

  public:
    PresetFilterMenu(PresetLibrary& presets, QWidget* parent = nullptr);

    const PresetFilter& filter() const { return filter_; }
    /// Describes the filter in a few words: "Metal · Favourites"; "All presets" without one.
    QString summary() const;
    void clearFilter();
    /// Asks for a folder and adds it to the library.
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
