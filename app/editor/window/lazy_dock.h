// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>

#include "window/dock_list.h"

namespace patina {

/// Makes the widget of a dock when the dock is first seen, so that tabs nobody opens cost nothing.
class LazyDock : public QDockWidget {
    Q_OBJECT

  public:
    LazyDock(DockEntry entry, const DockContext& context, QWidget* parent);

    /// Makes the widget now, unless it is there.
    void build();
    bool isBuilt() const { return !entry_.make; }

    /// Says that the dock was open in an earlier session: its height is the user's, and stays as it
    /// is.
    void keepHeight() { isNew_ = false; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void growToHint();

    DockEntry entry_;
    DockContext context_;
    bool isNew_ = true;
};

} // namespace patina
