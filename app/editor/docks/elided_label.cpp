// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/elided_label.h"

#include <QPainter>
#include <QStyle>

namespace patina {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setElidedText(const QString& text) {
    setText(text);
    setToolTip(text);
}

QString ElidedLabel::shown() const {
    if (wordWrap()) {
        return text();
    }
    return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
}

void ElidedLabel::paintEvent(QPaintEvent* event) {
    if (shown() == text()) {
        return QLabel::paintEvent(event);
    }
    QPainter painter(this);
    style()->drawItemText(&painter, contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, palette(),
                          isEnabled(), shown(), foregroundRole());
}

} // namespace patina
