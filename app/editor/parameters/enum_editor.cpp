// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/enum_editor.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "parameters/choice_box.h"
#include "parameters/editor_factory.h"

namespace patina {

EnumEditor::EnumEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent), box_(new ChoiceBox(this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(box_, 1);
    box_->setAccessibleName(name());
    for (const EnumValue& value : parameter.values) {
        box_->addItem(QString::fromStdString(value.label), QString::fromStdString(value.id));
        box_->setItemData(box_->count() - 1, QString::fromStdString(value.doc), Qt::ToolTipRole);
    }
    connect(box_, &QComboBox::activated, this, [this](int index) {
        Q_EMIT edited(Value(box_->itemData(index).toString().toStdString()));
    });
}

void EnumEditor::present(const Value& value) {
    if (const auto* id = std::get_if<std::string>(&value)) {
        const int index = box_->findData(QString::fromStdString(*id));
        const QSignalBlocker quiet(box_);
        box_->setCurrentIndex(index);
    }
}

QWidget* EnumEditor::focusTarget() {
    return box_;
}

ParameterEditor* makeEnumEditor(const Parameter& parameter, QWidget* parent) {
    return new EnumEditor(parameter, parent);
}

} // namespace patina
