// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "docks/dock_context.h"
#include "library/preset_entry.h"

class QShortcut;
class QWidget;

namespace patina {

class NoticeBar;

/// Shows a preset on the active side without an edit, until it is applied, until Esc, or until the
/// focus leaves a panel for another one than a view.
class PresetTrial : public QObject {
    Q_OBJECT

  public:
    /// All outlive it. What is tried is said in `notice`.
    PresetTrial(const DockContext& context, NoticeBar& notice, QWidget& panel);

    void begin(const PresetPtr& entry);
    void end();

    /// Ends the trial and puts a preset on the active side as an edit; null: it only ends.
    void apply(const PresetPtr& entry);

    bool isGoingOn() const { return tried_ != nullptr; }

  private:
    void followFocus(const QWidget* now);

    DockContext context_;
    NoticeBar& notice_;
    QWidget& panel_;
    QShortcut* back_; ///< ends it
    PresetPtr tried_; ///< null: none is going on
};

} // namespace patina
