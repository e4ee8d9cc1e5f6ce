// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/int_editor.h"

#include <cmath>

#include <QHBoxLayout>

#include "parameters/number_edit.h"
#include "parameters/value_slider.h"

namespace patina {

IntEditor::IntEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent),
      number_(new NumberEdit(parameter, std::get<int>(parameter.defaultValue), name(), this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(number_);
    connect(number_, &NumberEdit::interactionBegan, this, &ParameterEditor::interactionBegan);
    connect(number_, &NumberEdit::interactionEnded, this, &ParameterEditor::interactionEnded);
    connect(number_, &NumberEdit::edited, this,
            [this](double wanted) { Q_EMIT edited(Value(static_cast<int>(std::lround(wanted)))); });
}

void IntEditor::present(const Value& value) {
    if (const int* number = std::get_if<int>(&value)) {
        number_->present(*number);
    }
}

QWidget* IntEditor::focusTarget() {
    return number_->slider();
}

} // namespace patina
