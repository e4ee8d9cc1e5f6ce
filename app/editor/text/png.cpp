// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/png.h"

#include <QBuffer>

namespace patina {

QByteArray asPng(const QImage& picture, int quality) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return picture.save(&buffer, "PNG", quality) ? bytes : QByteArray();
}

} // namespace patina
