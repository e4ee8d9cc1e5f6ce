// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/color_swatch.h"

#include <QPainter>

#include "core/color.h"

namespace patina {

ColorSwatch::ColorSwatch(QWidget* parent)
    : PreviewButton(
          [this](QPainter& painter, const QRectF& area) {
              painter.fillRect(area, QColor(QString::fromStdString(hexOf(color_))));
          },
          parent) {}

void ColorSwatch::setColor(const glm::dvec3& linear) {
    color_ = linear;
    setAccessibleDescription(QString::fromStdString(hexOf(linear)));
    update();
}

QSize ColorSwatch::sizeHint() const {
    const int line = fontMetrics().height();
    return {line * 6, line + 6};
}

} // namespace patina
