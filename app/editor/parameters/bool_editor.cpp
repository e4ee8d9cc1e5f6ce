// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/bool_editor.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "parameters/editor_factory.h"

namespace patina {

BoolEditor::BoolEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent), box_(new QCheckBox(this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 2, 0, 2);
    line->addWidget(box_);
    line->addStretch(1);
    box_->setAccessibleName(name());
    connect(box_, &QCheckBox::toggled, this, [this](bool on) { Q_EMIT edited(Value(on)); });
}

void BoolEditor::present(const Value& value) {
    const bool* on = std::get_if<bool>(&value);
    if (on) {
        const QSignalBlocker quiet(box_);
        box_->setChecked(*on);
    }
}

QWidget* BoolEditor::focusTarget() {
    return box_;
}

ParameterEditor* makeBoolEditor(const Parameter& parameter, QWidget* parent) {
    return new BoolEditor(parameter, parent);
}

} // namespace patina
