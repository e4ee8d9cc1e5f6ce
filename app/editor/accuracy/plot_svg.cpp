// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/plot_svg.h"

#include "accuracy/plot_library.h"
#include "text/svg.h"

namespace patina {

QByteArray plotSvg(QCustomPlot& plot, QSize size, const QString& title,
                   const QString& description) {
    return asSvg(size, title, description, [&plot, size](QPaintDevice& device) {
        QCPPainter painter;
        painter.begin(&device);
        painter.setMode(QCPPainter::pmVectorized);
        painter.setMode(QCPPainter::pmNoCaching);
        plot.toPainter(&painter, size.width(), size.height());
        painter.end();
    });
}

} // namespace patina
