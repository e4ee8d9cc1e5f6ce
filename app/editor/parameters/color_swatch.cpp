// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/color_swatch.h"

#include <QKeyEvent>
#include <QPainter>

#include "core/color.h"

namespace patina {

ColorSwatch::ColorSwatch(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void ColorSwatch::setColor(const glm::dvec3& linear) {
    color_ = linear;
    setAccessibleDescription(QString::fromStdString(hexOf(linear)));
    update();
}

QSize ColorSwatch::sizeHint() const {
    const int line = fontMetrics().height();
    return {line * 6, line + 6};
}

void ColorSwatch::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        click();
        return;
    }
    QAbstractButton::keyPressEvent(event);
}

void ColorSwatch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor shown(QString::fromStdString(hexOf(color_)));
    QColor edge = palette().color(hasFocus() ? QPalette::Highlight : QPalette::WindowText);
    edge.setAlphaF(hasFocus() ? 1.0f : 0.35f);
    painter.setPen(QPen(edge, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(shown);
    painter.setOpacity(isEnabled() ? 1.0 : 0.4);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 3.0, 3.0);
}

} // namespace patina
