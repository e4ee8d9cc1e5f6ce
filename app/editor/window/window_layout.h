// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "window/dock_list.h"

class QAction;
class QDockWidget;
class QMainWindow;

namespace patina {

class LazyDock;
class Session;

/// Arranges the window and its docks: in the layout of a first start, or as they were when the
/// program was closed.
class WindowLayout {
  public:
    /// Makes every dock. The window and what the context refers to outlive it.
    WindowLayout(QMainWindow& window, const DockContext& context);
    ~WindowLayout();
    WindowLayout(const WindowLayout&) = delete;
    WindowLayout& operator=(const WindowLayout&) = delete;

    /// Returns the dock of a name; null where there is none.
    QDockWidget* dock(const QString& name) const;
    /// Returns the actions that show and hide each dock, in the order of dockList().
    std::vector<QAction*> dockActions() const;
    /// Shows a dock, which may lie behind other tabs.
    void bringToFront(const QString& name) const;
    /// Shows a tab of a dock by its place in the entry's pages.
    void openPage(const QString& name, int page) const;
    const std::vector<DockEntry>& entries() const { return entries_; }

    /// Restores the sizes and places that store() saved; a window that the session does not know
    /// gets a usual size.
    void restore(const Session& session);
    void store(Session& session) const;
    /// Arranges the docks as at a first start, unless a layout was restored. The window has to have
    /// its size by now.
    void arrangeOnce();
    /// Moves all docks back to where they stand at a first start.
    void reset();

  private:
    void arrange();
    void hideBottom();

    QMainWindow& window_;
    const MessageLog& messages_;
    std::vector<DockEntry> entries_ = dockList();
    std::map<QString, LazyDock*> docks_;
    std::map<DockPlace, QDockWidget*> firstDocks_; ///< holds the dock that is on top at each place
    bool isArranged_ = false;
};

} // namespace patina
