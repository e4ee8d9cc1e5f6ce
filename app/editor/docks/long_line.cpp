// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/long_line.h"

#include <QPainter>
#include <QStyle>

namespace patina {

LongLine::LongLine(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void LongLine::tell(const QString& text) {
    setText(text);
    setToolTip(text);
}

QString LongLine::shown() const {
    if (wordWrap()) {
        return text();
    }
    return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
}

void LongLine::paintEvent(QPaintEvent* event) {
    if (shown() == text()) {
        return QLabel::paintEvent(event);
    }
    QPainter painter(this);
    style()->drawItemText(&painter, contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, palette(),
                          isEnabled(), shown(), foregroundRole());
}

} // namespace patina
