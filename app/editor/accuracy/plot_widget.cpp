// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/plot_widget.h"

#include <QEvent>

namespace patina {

/// Draws in the plot's own event, since its page gets the event before the plot has the new
/// palette.
void PlotWidget::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        draw();
    }
}

} // namespace patina
