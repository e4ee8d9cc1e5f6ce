// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/value_box.h"

#include <QKeyEvent>

namespace patina {

bool asksForUndo(const QEvent& event) {
    if (event.type() != QEvent::ShortcutOverride) {
        return false;
    }
    const auto& press = static_cast<const QKeyEvent&>(event);
    return press.matches(QKeySequence::Undo) || press.matches(QKeySequence::Redo);
}

ValueBox::ValueBox(QWidget* parent) : QLineEdit(parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setContextMenuPolicy(Qt::NoContextMenu); // the row has one
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(this, &QLineEdit::returnPressed, this, [this] {
        commit();
        selectAll();
    });
}

QSize ValueBox::sizeHint() const {
    // Room for "-0.0001" and "1000000" beside the longest usual unit, the same in every row.
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("-0.0000 deg")) + 20;
    return {width, QLineEdit::sizeHint().height()};
}

bool ValueBox::event(QEvent* event) {
    if (!isModified() && asksForUndo(*event)) {
        event->ignore();
        return false;
    }
    return QLineEdit::event(event);
}

void ValueBox::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && isModified()) {
        showValue();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void ValueBox::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason) {
        commit();
        showValue();
    }
}

} // namespace patina
