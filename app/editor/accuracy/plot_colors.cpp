// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/plot_colors.h"

#include "accuracy/plot_library.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {

void colourPlot(QCustomPlot& plot, const QPalette& palette, bool stale) {
    const QColor base = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor faint = palette.color(QPalette::PlaceholderText);
    plot.setBackground(base);
    plot.setLocale(numberLocale()); // of the ticks
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setBasePen(mixed(base, text, 0.4));
        axis->setTickPen(mixed(base, text, 0.4));
        axis->setTickLabelColor(stale ? faint : mixed(base, text, 0.8));
        axis->setLabelColor(faint);
        axis->setTickLabelFont(plot.font());
        axis->setLabelFont(plot.font());
        axis->grid()->setPen(mixed(base, text, 0.12));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
}

} // namespace patina
