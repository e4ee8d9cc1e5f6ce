// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/plot_widget.h"

#include <QEvent>

namespace patina {

/// The page hears of another look before its plots have the new palette.
void PlotWidget::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        draw();
    }
}

} // namespace patina
