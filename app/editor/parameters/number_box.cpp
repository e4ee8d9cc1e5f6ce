// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/number_box.h"

#include <cmath>

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include "core/number_text.h"
#include "parameters/number_expression.h"
#include "parameters/number_format.h"

namespace patina {

namespace {

constexpr double wheelNotch = 120; // QWheelEvent::angleDelta of one notch
constexpr double pageSteps = 10.0;
constexpr double fine = 0.1;
const QColor wrong(196, 64, 48); // readable on light and dark

} // namespace

NumberBox::NumberBox(int decimals, const QString& unit, QWidget* parent)
    : QLineEdit(parent), decimals_(decimals), unit_(unit),
      shown_(QString::fromStdString(shownUnit(unit.toStdString()))) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setContextMenuPolicy(Qt::NoContextMenu); // the row has one
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setMaxLength(64);
    updateMargins();
    connect(this, &QLineEdit::textEdited, this, &NumberBox::markWhetherValid);
    connect(this, &QLineEdit::returnPressed, this, [this] {
        commit();
        selectAll();
    });
    showValue();
}

void NumberBox::setValue(double value) {
    const bool isBeingTyped = hasFocus() && isModified();
    value_ = value;
    if (!isBeingTyped) {
        showValue();
    }
}

void NumberBox::showValue() {
    const std::string text =
        hasFocus() ? shortestText(static_cast<float>(value_)) : shownNumber(value_, decimals_);
    if (const QString shown = QString::fromStdString(text); shown != this->text()) {
        setText(shown);
        setCursorPosition(0);
    }
    setModified(false);
    markWhetherValid();
    if (hasFocus()) {
        selectAll();
    }
}

void NumberBox::commit() {
    if (!isModified()) {
        return;
    }
    const std::optional<double> number = evaluateNumber(text().toStdString(), unit_.toStdString());
    setModified(false);
    if (number) {
        Q_EMIT typed(*number);
    }
    showValue(); // as it was accepted, or as it was before
}

void NumberBox::markWhetherValid() {
    const bool isWrong = isModified() && !evaluateNumber(text().toStdString(), unit_.toStdString());
    QPalette colors;
    if (isWrong) {
        colors.setColor(QPalette::Text, wrong);
    }
    setPalette(colors);
}

/// Ctrl+Z is the document's, except while there is typing to take back.
bool NumberBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        const auto* press = static_cast<QKeyEvent*>(event);
        if (press->matches(QKeySequence::Undo) || press->matches(QKeySequence::Redo)) {
            event->ignore();
            return false;
        }
    }
    return QLineEdit::event(event);
}

void NumberBox::keyPressEvent(QKeyEvent* event) {
    const double finer = event->modifiers() & Qt::ShiftModifier ? fine : 1.0;
    switch (event->key()) {
    case Qt::Key_Up:
        commit();
        Q_EMIT stepped(finer);
        return;
    case Qt::Key_Down:
        commit();
        Q_EMIT stepped(-finer);
        return;
    case Qt::Key_PageUp:
        commit();
        Q_EMIT stepped(pageSteps);
        return;
    case Qt::Key_PageDown:
        commit();
        Q_EMIT stepped(-pageSteps);
        return;
    case Qt::Key_Escape:
        if (isModified()) {
            showValue();
            return;
        }
        event->ignore();
        return;
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void NumberBox::wheelEvent(QWheelEvent* event) {
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    wheelRest_ += event->angleDelta().y() / wheelNotch;
    const double notches = std::trunc(wheelRest_);
    wheelRest_ -= notches;
    if (notches != 0.0) {
        commit();
        Q_EMIT stepped(notches * (event->modifiers() & Qt::ShiftModifier ? fine : 1.0));
    }
    event->accept();
}

void NumberBox::focusInEvent(QFocusEvent* event) {
    QLineEdit::focusInEvent(event);
    if (!isModified()) {
        showValue();
    }
    selectOnRelease_ = event->reason() == Qt::MouseFocusReason;
}

void NumberBox::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason) {
        commit();
        showValue();
    }
}

/// The first click selects all, so that typing replaces; a second one places the cursor.
void NumberBox::mouseReleaseEvent(QMouseEvent* event) {
    QLineEdit::mouseReleaseEvent(event);
    if (std::exchange(selectOnRelease_, false) && !hasSelectedText()) {
        selectAll();
    }
}

void NumberBox::changeEvent(QEvent* event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        updateMargins();
        updateGeometry();
    }
}

void NumberBox::updateMargins() {
    const int gap = fontMetrics().horizontalAdvance(QLatin1Char('0')); // 0.1 1/m, not 0.11/m
    setTextMargins(0, 0, unit_.isEmpty() ? 0 : fontMetrics().horizontalAdvance(shown_) + gap, 0);
}

QSize NumberBox::sizeHint() const {
    const QSize line = QLineEdit::sizeHint();
    // Room for "-0.0001" and "1000000" beside the longest usual unit, the same in every row.
    return {fontMetrics().horizontalAdvance(QStringLiteral("-0.0000 deg")) + 20, line.height()};
}

void NumberBox::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (!unit_.isEmpty()) {
        QPainter painter(this);
        QColor color = palette().color(QPalette::WindowText);
        color.setAlphaF(isEnabled() ? 0.6f : 0.35f);
        painter.setPen(color);
        painter.drawText(rect().adjusted(0, 0, -7, 0), Qt::AlignRight | Qt::AlignVCenter, shown_);
    }
}

} // namespace patina
