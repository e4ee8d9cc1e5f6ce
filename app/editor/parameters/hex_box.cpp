// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/hex_box.h"

#include <QKeyEvent>

#include "parameters/value_text.h"

namespace patina {

HexBox::HexBox(QWidget* parent) : QLineEdit(parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setContextMenuPolicy(Qt::NoContextMenu); // the row has one
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setMaxLength(16);
    setToolTip(tr("The colour as screens count it: sRGB hex"));
    connect(this, &QLineEdit::returnPressed, this, &HexBox::commit);
}

void HexBox::setColor(const glm::dvec3& linear) {
    color_ = linear;
    if (!(hasFocus() && isModified())) {
        showColor();
    }
}

void HexBox::showColor() {
    setText(QString::fromStdString(hexOf(color_)));
    setModified(false);
}

/// Hex is coarse: a colour whose hex is what stands there already is not touched.
void HexBox::commit() {
    const std::string text = this->text().toStdString();
    const std::optional<glm::dvec3> typedColor = colorOfHex(text);
    const bool isNew = isModified() && typedColor && hexOf(*typedColor) != hexOf(color_);
    setModified(false);
    if (isNew) {
        Q_EMIT typed(*typedColor);
    }
    showColor();
}

/// Ctrl+Z is the document's, except while there is typing to take back.
bool HexBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        const auto* press = static_cast<QKeyEvent*>(event);
        if (press->matches(QKeySequence::Undo) || press->matches(QKeySequence::Redo)) {
            event->ignore();
            return false;
        }
    }
    return QLineEdit::event(event);
}

void HexBox::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && isModified()) {
        showColor();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void HexBox::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    commit();
}

QSize HexBox::sizeHint() const {
    const int height = QLineEdit::sizeHint().height();
    return {fontMetrics().horizontalAdvance(QStringLiteral("-0.0000 deg")) + 20, height};
}

} // namespace patina
