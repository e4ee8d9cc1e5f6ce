// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/key_pause.h"

#include <QDialog>
#include <QEvent>
#include <QTimer>

namespace patina {

KeyPause::KeyPause(QDialog& dialog) : QObject(&dialog) {
    dialog.installEventFilter(this);
    for (QWidget* child : dialog.findChildren<QWidget*>()) {
        child->installEventFilter(this);
    }
}

bool KeyPause::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::Paint:
        if (!isSeen_) {
            isSeen_ = true;
            QTimer::singleShot(pauseMs, this, &QObject::deleteLater);
        }
        break;
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::ShortcutOverride:
        return true;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace patina
