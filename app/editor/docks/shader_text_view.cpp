// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/shader_text_view.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QFontDatabase>
#include <QPainter>
#include <QTextBlock>

namespace patina {
namespace {

constexpr int marginGap = 8; ///< pixels beside the margin's text

} // namespace

ShaderTextView::ShaderTextView(QWidget* parent)
    : QPlainTextEdit(parent), margin_(new QWidget(this)) {
    setReadOnly(true);
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    margin_->installEventFilter(this);
    connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
        dy != 0 ? margin_->scroll(0, dy)
                : margin_->update(0, rect.y(), margin_->width(), rect.height());
    });
    placeMargin();
}

void ShaderTextView::setMargins(Margins margins, int marked) {
    margins_ = std::move(margins);
    marked_ = marked;
    placeMargin();
    margin_->update();
}

void ShaderTextView::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    placeMargin();
}

void ShaderTextView::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        placeMargin();
    }
}

bool ShaderTextView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == margin_ && event->type() == QEvent::Paint) {
        paintMargin();
        return true;
    }
    return QPlainTextEdit::eventFilter(watched, event);
}

void ShaderTextView::placeMargin() {
    int width = 0;
    for (const auto& [line, text] : margins_) {
        width = std::max(width, fontMetrics().horizontalAdvance(text) + 2 * marginGap);
    }
    setViewportMargins(width, 0, 0, 0);
    const QRect inside = contentsRect();
    margin_->setGeometry(inside.left(), inside.top(), width, inside.height());
    margin_->setVisible(width > 0);
}

void ShaderTextView::paintMargin() {
    QPainter painter(margin_);
    painter.fillRect(margin_->rect(), palette().alternateBase());
    painter.setFont(font());
    QTextBlock block = firstVisibleBlock();
    QRectF place = blockBoundingGeometry(block).translated(contentOffset());
    for (; block.isValid() && place.top() <= margin_->height(); block = block.next()) {
        place = blockBoundingGeometry(block).translated(contentOffset());
        const auto found = margins_.find(block.blockNumber() + 1);
        if (found == margins_.end()) {
            continue;
        }
        const bool isMarked = found->first == marked_;
        const QRectF line(0.0, place.top(), margin_->width(), fontMetrics().height());
        if (isMarked) {
            painter.fillRect(line, palette().highlight());
        }
        painter.setPen(palette().color(isMarked ? QPalette::HighlightedText : QPalette::Text));
        painter.drawText(line.adjusted(marginGap, 0.0, -marginGap, 0.0),
                         Qt::AlignRight | Qt::AlignVCenter, found->second);
    }
}

} // namespace patina
