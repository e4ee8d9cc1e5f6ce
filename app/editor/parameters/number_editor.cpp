// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/number_editor.h"

#include <cmath>

#include <QHBoxLayout>

#include "parameters/editor_factory.h"
#include "parameters/slider_with_box.h"
#include "parameters/value_slider.h"

namespace patina {

namespace {

double numberOf(const Value& value) {
    const int* whole = std::get_if<int>(&value);
    return whole ? *whole : std::get<double>(value);
}

} // namespace

NumberEditor::NumberEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent),
      number_(new SliderWithBox(parameter, numberOf(parameter.defaultValue), name(), this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(number_);
    connect(number_, &SliderWithBox::interactionBegan, this, &ParameterEditor::interactionBegan);
    connect(number_, &SliderWithBox::interactionEnded, this, &ParameterEditor::interactionEnded);
    connect(number_, &SliderWithBox::edited, this,
            [this](double wanted) { Q_EMIT edited(valueOf(wanted)); });
}

Value NumberEditor::valueOf(double number) const {
    const bool isWhole = infoOf(parameter().type).isWhole;
    return isWhole ? Value(static_cast<int>(std::lround(number))) : Value(number);
}

void NumberEditor::present(const Value& value) {
    if (std::holds_alternative<int>(value) || std::holds_alternative<double>(value)) {
        number_->present(numberOf(value));
    }
}

QWidget* NumberEditor::focusTarget() {
    return number_->slider();
}

void NumberEditor::scrubWith(ScrubLabel& label) {
    number_->scrubWith(label);
}

ParameterEditor* makeFloatEditor(const Parameter& parameter, QWidget* parent) {
    return new NumberEditor(parameter, parent);
}

ParameterEditor* makeIntEditor(const Parameter& parameter, QWidget* parent) {
    return new NumberEditor(parameter, parent);
}

ParameterEditor* makeAngleEditor(const Parameter& parameter, QWidget* parent) {
    return new NumberEditor(parameter, parent);
}

} // namespace patina
