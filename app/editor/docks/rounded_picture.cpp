// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/rounded_picture.h"

#include <QPainter>

namespace patina {

QIcon rounded(const QImage& picture) {
    QPixmap rounded(picture.size());
    rounded.fill(Qt::transparent);
    QPainter painter(&rounded);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(QBrush(picture));
    painter.setPen(Qt::NoPen);
    const double radius = 0.07 * picture.width();
    painter.drawRoundedRect(rounded.rect(), radius, radius);
    painter.end();
    QIcon icon(rounded);
    icon.addPixmap(rounded, QIcon::Selected);
    return icon;
}

} // namespace patina
