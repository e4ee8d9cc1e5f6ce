// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace patina {

/// Shows a popup below what opens it, or above where there is no room, inside the screen.
void openBeside(QWidget& popup, const QWidget& anchor);

} // namespace patina
