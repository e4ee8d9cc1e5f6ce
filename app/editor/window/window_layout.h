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

/// Knows how large the window is and where its docks stand, at a first start and again at the next.
class WindowLayout {
  public:
    /// Makes every dock. What the context has and the window outlive it.
    WindowLayout(QMainWindow& window, const DockContext& context);
    ~WindowLayout();
    WindowLayout(const WindowLayout&) = delete;
    WindowLayout& operator=(const WindowLayout&) = delete;

    /// Null where there is none of that name.
    QDockWidget* dock(const QString& name) const;
    /// Returns what shows and hides each dock.
    std::vector<QAction*> dockActions() const;
    /// Shows a dock, which may lie behind other tabs.
    void bringToFront(const QString& name) const;

    /// As it was when it was stored.
    void restore(const Session& session);
    void store(Session& session) const;
    /// As at a first start, unless it was restored. The window has its size by now.
    void arrangeOnce();
    /// Puts all docks back to where they stand at a first start.
    void reset();

  private:
    void arrange();
    void hideBottom();

    QMainWindow& window_;
    const MessageLog& messages_;
    std::vector<DockEntry> entries_ = dockList();
    std::map<QString, LazyDock*> docks_;
    std::map<DockPlace, QDockWidget*> firstDocks_; ///< the one that is on top at each place
    bool isArranged_ = false;
};

} // namespace patina
