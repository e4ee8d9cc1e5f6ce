// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>

#include "window/dock_list.h"

namespace patina {

/// A dock whose widget is made when it is first seen, so that tabs nobody opens cost nothing.
class LazyDock : public QDockWidget {
    Q_OBJECT

  public:
    LazyDock(DockEntry entry, const DockContext& context, QWidget* parent);

    /// Makes the widget now.
    void build();
    bool isBuilt() const { return !entry_.make; }

    /// It was open before: its height is the user's, and stays as it is.
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
