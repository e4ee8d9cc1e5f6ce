// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/plot_svg.h"

#include <QBuffer>
#include <QSvgGenerator>

#include "accuracy/plot_library.h"

namespace patina {

QByteArray plotSvg(QCustomPlot& plot, QSize size, const QString& title,
                   const QString& description) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(title);
    generator.setDescription(description);
    QCPPainter painter;
    painter.begin(&generator);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot.toPainter(&painter, size.width(), size.height());
    painter.end();
    return bytes;
}

} // namespace patina
