// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QString>

#include "docks/dock_context.h"
#include "docks/dock_page.h"

class QWidget;

namespace patina {

/// Tells where a dock stands in the layout of a first start. Docks of one place are tabs.
enum class DockPlace { LeftTop, LeftBottom, RightTop, RightBottom, Bottom };

/// Describes a dock: its name in saved layouts, its title, its place, how its widget is made, which
/// happens when it is first seen, words by which it is found besides its title, and its tabs where
/// each of them has a command.
struct DockEntry {
    QString name;
    QString title;
    DockPlace place;
    std::function<QWidget*(const DockContext&)> make;
    QString contents = {};
    std::vector<DockPage> pages = {};
};

/// Returns every dock there is, in the order of the View menu.
std::vector<DockEntry> dockList();

} // namespace patina
