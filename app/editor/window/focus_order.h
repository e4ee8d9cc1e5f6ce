// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

class QMainWindow;
class QWidget;

namespace patina {

/// Everything in a window that Tab goes to, as it is read: panel by panel from the left, each row
/// by row. What lies in a panel behind another's tab is not among them. Forms are made anew while
/// the window is open, so the order in which widgets were made says nothing.
std::vector<QWidget*> focusOrder(const QMainWindow& window);

/// Moves the focus of a window to the next or the previous of them and scrolls there; false when
/// there is none.
bool moveFocus(const QMainWindow& window, bool forwards);

} // namespace patina
