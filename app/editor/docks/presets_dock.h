// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"
#include "docks/library_steps.h"
#include "docks/preset_actions.h"
#include "docks/preset_transfer.h"
#include "docks/preset_trial.h"
#include "library/preset_query.h"

class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace patina {

class NoticeBar;
class PresetFilterMenu;
class PresetView;
struct VariantChange;

/// Shows the preset library: presets that ship and the user's own, searched, filtered and sorted. A
/// click tries one, a double click or Enter, also in the search, applies it. Dragging puts it where
/// it is dropped. While A and B are compared the arrows put one after the other on B, with Shift on
/// A.
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
    void tellVariants(const std::vector<VariantChange>& changes);
    void exportBundle();
    void storeLook();
    void step(int by, bool isOther);

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
    PresetOrder order_ = PresetOrder::Name;
    PresetTrial trial_;
    PresetActions actions_;
    PresetTransfer transfer_;
    LibrarySteps steps_;
};

} // namespace patina
