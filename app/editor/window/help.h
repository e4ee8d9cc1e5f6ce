// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace patina {

/// Shows what the mouse and the keys do that no menu names.
void showKeys(QWidget* window);

/// Shows what the program is, its version and its licence.
void showAbout(QWidget* window);

} // namespace patina
