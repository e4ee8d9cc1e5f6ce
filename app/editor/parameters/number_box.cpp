// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/number_box.h"

#include <utility>

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include "core/number_text.h"
#include "parameters/number_expression.h"
#include "parameters/number_format.h"
#include "text/short_text.h"

namespace patina {

namespace {

/// A unit is cut to so many letters; more would leave no room for the number.
constexpr int maxUnit = 6;

const QColor wrong(196, 64, 48); // can be read on light and dark

} // namespace

NumberBox::NumberBox(int decimals, const QString& unit, QWidget* parent)
    : ValueBox(parent), decimals_(decimals), unit_(unit),
      shown_(shortened(QString::fromStdString(shownUnit(unit.toStdString())), maxUnit)) {
    setMaxLength(64);
    updateMargins();
    connect(this, &QLineEdit::textEdited, this, &NumberBox::markWhetherValid);
    showValue();
}

void NumberBox::setZeroText(const QString& text) {
    zeroText_ = text;
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
    if (const QString shown = textOf(value_); shown != text()) {
        setText(shown);
        setCursorPosition(0);
    }
    setModified(false);
    updateMargins();
    markWhetherValid();
    if (hasFocus()) {
        selectAll();
    }
}

bool NumberBox::showsZeroText() const {
    return !hasFocus() && value_ == 0.0 && !zeroText_.isEmpty();
}

QString NumberBox::textOf(double value) const {
    if (showsZeroText()) {
        return zeroText_;
    }
    return QString::fromStdString(hasFocus() ? shortestText(static_cast<float>(value))
                                             : shownNumber(value, decimals_));
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

void NumberBox::keyPressEvent(QKeyEvent* event) {
    if (const std::optional<double> steps = stepsOf(*event)) {
        commit();
        Q_EMIT stepped(*steps);
        return;
    }
    ValueBox::keyPressEvent(event);
}

void NumberBox::wheelEvent(QWheelEvent* event) {
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    if (const double steps = wheel_.take(*event); steps != 0.0) {
        commit();
        Q_EMIT stepped(steps);
    }
    event->accept();
}

void NumberBox::focusInEvent(QFocusEvent* event) {
    ValueBox::focusInEvent(event);
    if (!isModified()) {
        showValue();
    }
    selectOnRelease_ = event->reason() == Qt::MouseFocusReason;
}

/// The first click selects all, so that typing replaces; a second one places the cursor.
void NumberBox::mouseReleaseEvent(QMouseEvent* event) {
    ValueBox::mouseReleaseEvent(event);
    if (std::exchange(selectOnRelease_, false) && !hasSelectedText()) {
        selectAll();
    }
}

void NumberBox::changeEvent(QEvent* event) {
    ValueBox::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        updateMargins();
        updateGeometry();
    }
}

void NumberBox::updateMargins() {
    const int gap = fontMetrics().horizontalAdvance(QLatin1Char('0')); // 0.1 1/m, not 0.11/m
    const bool hasUnit = !unit_.isEmpty() && !showsZeroText();
    setTextMargins(0, 0, hasUnit ? fontMetrics().horizontalAdvance(shown_) + gap : 0, 0);
}

void NumberBox::paintEvent(QPaintEvent* event) {
    ValueBox::paintEvent(event);
    if (!unit_.isEmpty() && !showsZeroText()) {
        QPainter painter(this);
        QColor color = palette().color(QPalette::WindowText);
        color.setAlphaF(isEnabled() ? 0.6f : 0.35f);
        painter.setPen(color);
        painter.drawText(rect().adjusted(0, 0, -7, 0), Qt::AlignRight | Qt::AlignVCenter, shown_);
    }
}

} // namespace patina
