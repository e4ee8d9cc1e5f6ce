// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>

#include "docks/dock_context.h"
#include "files/preset_edits.h"

class QAction;
class QKeySequence;

namespace patina {

class NoticeBar;
class PresetTrial;
class PresetView;

/// Edits the files of the presets that are selected in a view, by actions of that view and their
/// keys, and says in a notice what became of each edit, which can be undone there.
class PresetActions : public QObject {
    Q_OBJECT

  public:
    /// All outlive it.
    PresetActions(const DockContext& context, PresetView& view, PresetTrial& trial,
                  NoticeBar& notice);

    /// Enables what the selected presets allow.
    void update();

    /// Shows the menu of the preset at a place of the view.
    void showMenu(const QPoint& place);

    /// Says that an import made this folder, and lets it be undone.
    void noteImport(const QString& folder, const QString& text);

  private:
    QAction* add(const QString& text, const QKeySequence& key, void (PresetActions::*act)());
    void addAll();
    void rename();
    void duplicate();
    void makeVariants();
    void detach();
    void editTags();
    void toggleFavourites();
    void moveToTrash();
    void undo();
    void redo();
    void report(const QString& what, const std::vector<PresetOutcome>& outcomes);
    void sayDone(const QString& text, bool isAnyDone);

    DockContext context_;
    PresetView& view_;
    PresetTrial& trial_;
    NoticeBar& notice_;
    PresetEdits edits_;
    bool isLastEdit_ = false; ///< nothing was edited in the document since the last edit here
    bool isUndoing_ = false;  ///< the edit that is reported is the undo of one
    QAction* rename_ = nullptr;
    QAction* detach_ = nullptr;
    QAction* tags_ = nullptr;
    QAction* favourite_ = nullptr;
    QAction* trash_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
};

} // namespace patina
