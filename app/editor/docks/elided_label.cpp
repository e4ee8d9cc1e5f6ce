// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/elided_label.h"

#include <QPainter>
#include <QStyle>
#include <QTextLayout>

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

void ElidedLabel::setMaxLines(int lines) {
    maxLines_ = lines;
    setWordWrap(true);
    setMaximumHeight(lines * fontMetrics().lineSpacing());
}

/// Returns the text if it fits in the lines, else the lines with the last one elided.
QString ElidedLabel::wrapped() const {
    const QString all = text();
    QTextLayout layout(all, font(), this);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(contentsRect().width());
        if (lines.size() == maxLines_) { // there is more than fits
            const QString last = all.mid(layout.lineAt(maxLines_ - 1).textStart());
            lines.back() = fontMetrics().elidedText(last, Qt::ElideRight, contentsRect().width());
            return lines.join('\n');
        }
        lines << all.mid(line.textStart(), line.textLength()).trimmed();
    }
    return all;
}

QString ElidedLabel::shown() const {
    if (wordWrap()) {
        return maxLines_ > 0 ? wrapped() : text();
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
