// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/plot_colors.h"

#include <cmath>

#include "accuracy/plot_library.h"

namespace patina {

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto part = [share](int x, int y) {
        return static_cast<int>(std::lround((1.0 - share) * x + share * y));
    };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

void colourPlot(QCustomPlot& plot, const QPalette& palette, bool stale) {
    const QColor base = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor faint = palette.color(QPalette::PlaceholderText);
    plot.setBackground(base);
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
