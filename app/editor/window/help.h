// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

class QWidget;

namespace patina {

/// Says what some keys or a drag do.
struct KeyRow {
    QString keys;
    QString what;
};

/// Lists what the mouse and the keys do that no menu names.
std::vector<KeyRow> viewKeys();

/// Shows what the program is, its version and its licence.
void showAbout(QWidget* window);

} // namespace patina
