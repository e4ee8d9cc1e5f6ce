// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/search_box.h"

#include <QEvent>

#include "parameters/value_box.h"

namespace patina {

bool SearchBox::event(QEvent* event) {
    if (text().isEmpty() && asksForUndo(*event)) {
        event->ignore();
        return false;
    }
    return QLineEdit::event(event);
}

} // namespace patina
