// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/popup_place.h"

#include <algorithm>

#include <QScreen>
#include <QWidget>

namespace patina {

void openBeside(QWidget& popup, const QWidget& anchor) {
    popup.adjustSize();
    const QRect screen = anchor.screen()->availableGeometry();
    QPoint corner = anchor.mapToGlobal(QPoint(0, anchor.height() + 2));
    if (corner.y() + popup.height() > screen.bottom()) {
        const int above = anchor.mapToGlobal(QPoint(0, 0)).y() - popup.height() - 2;
        corner.setY(std::max(screen.top(), above));
    }
    corner.setX(std::clamp(corner.x(), screen.left(),
                           std::max(screen.left(), screen.right() - popup.width())));
    popup.move(corner);
    popup.show();
}

} // namespace patina
