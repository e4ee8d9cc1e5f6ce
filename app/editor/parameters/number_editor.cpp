// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/float_editor.h"

#include <QHBoxLayout>

#include "parameters/number_edit.h"
#include "parameters/value_slider.h"

namespace patina {

FloatEditor::FloatEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent),
      number_(new NumberEdit(parameter, std::get<double>(parameter.defaultValue), name(), this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(number_);
    connect(number_, &NumberEdit::interactionBegan, this, &ParameterEditor::interactionBegan);
    connect(number_, &NumberEdit::interactionEnded, this, &ParameterEditor::interactionEnded);
    connect(number_, &NumberEdit::edited, this,
            [this](double wanted) { Q_EMIT edited(Value(wanted)); });
}

void FloatEditor::present(const Value& value) {
    if (const double* number = std::get_if<double>(&value)) {
        number_->present(*number);
    }
}

QWidget* FloatEditor::focusTarget() {
    return number_->slider();
}

} // namespace patina
