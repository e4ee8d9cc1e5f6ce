// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/svg.h"

#include <QBuffer>
#include <QSvgGenerator>

namespace patina {

QByteArray asSvg(QSize size, const QString& title, const QString& description,
                 const std::function<void(QPaintDevice&)>& paint) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(title);
    generator.setDescription(description);
    paint(generator);
    return bytes;
}

} // namespace patina
