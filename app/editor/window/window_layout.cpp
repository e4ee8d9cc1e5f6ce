// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/window_layout.h"

#include <algorithm>

#include <QMainWindow>
#include <QScreen>
#include <QTabWidget>
#include <QTimer>

#include "docks/panel.h"
#include "session/message_log.h"
#include "session/session.h"
#include "window/lazy_dock.h"

namespace patina {
namespace {

/// Is raised when docks are added, removed or moved, so that an older layout is not applied to
/// them.
constexpr int layoutVersion = 7;

constexpr QSize preferredSize{1600, 1000};

/// Reserves pixels for a title bar and edges, at least as large as desktops draw them; the true
/// size is known only when the window is shown.
constexpr QSize usualFrame{12, 48};

constexpr int narrowWindow = 1400;

Qt::DockWidgetArea areaOf(DockPlace place) {
    switch (place) {
    case DockPlace::LeftTop:
    case DockPlace::LeftBottom:
        return Qt::LeftDockWidgetArea;
    case DockPlace::Bottom:
        return Qt::BottomDockWidgetArea;
    default:
        return Qt::RightDockWidgetArea;
    }
}

} // namespace

WindowLayout::WindowLayout(QMainWindow& window, const DockContext& context)
    : window_(window), messages_(context.messages) {
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    window.setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    for (const DockEntry& entry : entries_) {
        auto* dock = new LazyDock(entry, context, &window);
        docks_[entry.name] = dock;
        const auto [first, isFirst] = firstDocks_.try_emplace(entry.place, dock);
        window.addDockWidget(areaOf(entry.place), dock);
        if (!isFirst) {
            window.tabifyDockWidget(first->second, dock);
        }
    }
}

WindowLayout::~WindowLayout() {
    for (const auto& [name, dock] : docks_) {
        delete dock;
    }
}

QDockWidget* WindowLayout::dock(const QString& name) const {
    const auto found = docks_.find(name);
    return found == docks_.end() ? nullptr : found->second;
}

std::vector<QAction*> WindowLayout::dockActions() const {
    std::vector<QAction*> actions;
    for (const DockEntry& entry : entries_) {
        actions.push_back(dock(entry.name)->toggleViewAction());
    }
    return actions;
}

void WindowLayout::bringToFront(const QString& name) const {
    dock(name)->show();
    dock(name)->raise();
}

void WindowLayout::openPage(const QString& name, int page) const {
    LazyDock* dock = docks_.at(name);
    dock->build(); // before it is seen, so that no other page begins its work
    auto* tabs = qobject_cast<QTabWidget*>(dock->widget());
    tabs = tabs != nullptr ? tabs : dock->widget()->findChild<QTabWidget*>();
    if (tabs != nullptr) {
        tabs->setCurrentIndex(page);
        bringToFront(name);
        return;
    }
    bringToFront(name);
    const auto entry = std::ranges::find(entries_, name, &DockEntry::name);
    const QString title = entry->pages[static_cast<std::size_t>(page)].title;
    QTimer::singleShot(0, dock, [dock, title] { // when it has its place
        scrollToSection(*dock->widget(), title);
    });
}

/// Applies the layout of a first start: the material's look on the left, its values on the right,
/// and a large picture in the middle.
void WindowLayout::arrange() {
    for (const auto& [place, dock] : firstDocks_) {
        dock->show();
        dock->raise();
    }
    hideBottom();
    if (messages_.count() >
        messages_.noteCount()) { // about files that were opened before the window was shown
        bringToFront("messages");
    }
    const bool narrow = window_.width() < narrowWindow;
    const int left = narrow ? 212 : 276;
    const int right = narrow ? 384 : 440;
    window_.resizeDocks({dock("models"), dock("parameters")}, {left, right}, Qt::Horizontal);
    window_.resizeDocks({dock("models"), dock("presets")}, {10, 11}, Qt::Vertical);
    window_.resizeDocks({dock("parameters"), dock("lights")}, {11, 10}, Qt::Vertical);
}

/// Hides the docks for messages and checks, which are shown when there is something to say.
void WindowLayout::hideBottom() {
    for (const DockEntry& entry : entries_) {
        if (entry.place == DockPlace::Bottom) {
            dock(entry.name)->hide();
        }
    }
}

void WindowLayout::arrangeOnce() {
    if (!isArranged_) {
        isArranged_ = true;
        arrange();
    }
}

void WindowLayout::reset() {
    for (const auto& [place, first] : firstDocks_) {
        for (const DockEntry& entry : entries_) {
            QDockWidget* each = dock(entry.name);
            each->setFloating(false);
            if (entry.place == place && each != first) {
                each->show();
                window_.tabifyDockWidget(first, each);
            }
        }
    }
    arrange();
}

void WindowLayout::restore(const Session& session) {
    const QSize room = window_.screen()->availableSize() - usualFrame;
    window_.resize(preferredSize.boundedTo(room));
    const bool known = window_.restoreGeometry(session.windowGeometry());
    if (!known && window_.size() != preferredSize) {
        window_.setWindowState(Qt::WindowMaximized);
    }
    hideBottom();
    isArranged_ = window_.restoreState(session.windowLayout(), layoutVersion);
    const QStringList opened = session.openedDocks();
    for (const auto& [name, dock] : docks_) {
        if (isArranged_ && opened.contains(name)) {
            dock->keepHeight();
        }
    }
}

void WindowLayout::store(Session& session) const {
    session.setWindow(window_.saveGeometry(), window_.saveState(layoutVersion));
    QStringList opened = session.openedDocks();
    for (const auto& [name, dock] : docks_) {
        if (dock->isBuilt() && !opened.contains(name)) {
            opened << name;
        }
    }
    session.setOpenedDocks(opened);
}

} // namespace patina
