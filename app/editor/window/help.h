// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "session/mouse_scheme.h"

class QWidget;

namespace patina {

/// Says what some keys or a drag do.
struct KeyRow {
    QString keys;
    QString what;
};

/// Lists what the mouse and the keys do in a view and no menu names.
std::vector<KeyRow> viewKeys(const MouseHabits& habits);

/// Lists what they do on a value and in a list.
std::vector<KeyRow> valueKeys();

/// Shows what the program is, its version and its licence.
void showAbout(QWidget* window);

} // namespace patina
