// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"
#include "files/preset_bundles.h"
#include "files/preset_edits.h"
#include "library/preset_query.h"

class QAction;
class QKeySequence;
class QLabel;
class QLineEdit;
class QShortcut;
class QSlider;
class QToolButton;

namespace patina {

class NoticeBar;
class PresetFilterMenu;
class PresetView;
struct VariantChange;

/// The preset library: presets that ship and the user's own, searched, filtered and sorted. A click
/// shows one on the active side without an edit, until Esc or until the focus leaves for another
/// panel; a double click or Enter, also in the search, puts it there. Dragging puts it where it is
/// dropped.
class PresetsDock : public QWidget {
    Q_OBJECT

  public:
    explicit PresetsDock(const DockContext& context);

  protected:
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void build();
    QToolButton* orderButton();
    QToolButton* listButton();
    void connectParts();
    void fill();
    void say();
    void chooseAShownOne();
    void tryOut(const PresetPtr& entry);
    void endTrying();
    void apply(const PresetPtr& entry);
    void followFocus(const QWidget* now);
    void addActions();
    QAction* addFileAction(const QString& text, const QKeySequence& key,
                           void (PresetsDock::*act)());
    void updateActions();
    void showMenu(const QPoint& place);
    void rename();
    void duplicate();
    void makeVariants();
    void detach();
    void editTags();
    void toggleFavourites();
    void moveToTrash();
    void undoEdit();
    void redoEdit();
    void tellVariants(const std::vector<VariantChange>& changes);
    void tellEdit(const QString& what, const std::vector<PresetOutcome>& outcomes);
    void storeLook();
    void connectBundles();
    void exportBundle();
    void importBundle();
    QString toldBundle(const QString& done, const std::vector<BundleOutcome>& outcomes);
    void sayDone(const QString& text);

    DockContext context_;
    PresetLibrary& presets_;
    QLineEdit* search_;
    PresetFilterMenu* filter_;
    QToolButton* filterButton_;
    QLabel* hint_;
    PresetView* view_;
    QSlider* size_;
    QLabel* count_;
    NoticeBar* notice_;
    QShortcut* back_; ///< ends trying
    PresetOrder order_ = PresetOrder::Name;
    PresetPtr tried_;
    PresetEdits edits_;
    PresetBundles bundles_;
    bool isLastEdit_ = false; ///< nothing was edited in the document since the last edit here
    QAction* rename_ = nullptr;
    QAction* detach_ = nullptr;
    QAction* tags_ = nullptr;
    QAction* favourite_ = nullptr;
    QAction* trash_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
};

} // namespace patina
