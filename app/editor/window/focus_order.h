// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

class QMainWindow;
class QWidget;

namespace patina {

/// Returns all widgets of a window that Tab goes to, in the order of reading: panel by panel from
/// the left, each row by row. Those in a panel behind another's tab are left out. Forms are made
/// anew while the window is open, so the order in which widgets were made says nothing.
std::vector<QWidget*> focusOrder(const QMainWindow& window);

/// Moves the focus of a window to the next or the previous widget of focusOrder() and scrolls
/// there; returns false when there is none.
bool moveFocus(const QMainWindow& window, bool forwards);

} // namespace patina
