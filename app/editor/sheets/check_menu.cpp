// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/check_menu.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace patina {

QAction* CheckMenu::addCheck(const QString& text, bool isOn) {
    QAction* action = addAction(text);
    action->setCheckable(true);
    action->setChecked(isOn);
    return action;
}

void CheckMenu::mouseReleaseEvent(QMouseEvent* event) {
    if (!switched(actionAt(event->position().toPoint()))) {
        QMenu::mouseReleaseEvent(event);
    }
}

void CheckMenu::keyPressEvent(QKeyEvent* event) {
    const bool isSwitch = event->key() == Qt::Key_Space || event->key() == Qt::Key_Return ||
                          event->key() == Qt::Key_Enter;
    if (!isSwitch || !switched(activeAction())) {
        QMenu::keyPressEvent(event);
    }
}

/// Switches an action; returns false where it cannot be switched.
bool CheckMenu::switched(QAction* action) {
    const bool isSwitch = action && action->isCheckable() && action->isEnabled();
    if (isSwitch) {
        action->trigger();
    }
    return isSwitch;
}

} // namespace patina
