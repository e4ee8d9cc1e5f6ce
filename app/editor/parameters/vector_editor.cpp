// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/vector_editor.h"

#include <QGridLayout>

#include "parameters/editor_factory.h"
#include "parameters/scrub_label.h"
#include "parameters/slider_with_box.h"
#include "parameters/value_slider.h"

namespace patina {

namespace {

std::vector<double> componentsOf(const Value& value) {
    if (const auto* pair = std::get_if<glm::dvec2>(&value)) {
        return {pair->x, pair->y};
    }
    if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        return {triple->x, triple->y, triple->z};
    }
    return {};
}

} // namespace

VectorEditor::VectorEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent), value_(parameter.defaultValue) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    const std::vector<double> defaults = componentsOf(parameter.defaultValue);
    const std::vector<std::string> names = componentNames(parameter);
    for (int i = 0; i < static_cast<int>(defaults.size()); ++i) {
        const auto place = static_cast<std::size_t>(i);
        const QString component = QString::fromStdString(names[place]);
        auto* number = new SliderWithBox(parameter, defaults[place],
                                         name() + QLatin1Char(' ') + component, this);
        auto* letter = new ScrubLabel(component, this);
        number->scrubWith(*letter);
        letter->setBuddy(number->slider());
        grid->addWidget(letter, i, 0);
        grid->addWidget(number, i, 1);
        numbers_.push_back(number);
        connect(number, &SliderWithBox::interactionBegan, this, &ParameterEditor::interactionBegan);
        connect(number, &SliderWithBox::interactionEnded, this, &ParameterEditor::interactionEnded);
        connect(number, &SliderWithBox::edited, this,
                [this, i](double wanted) { Q_EMIT edited(withComponent(i, wanted)); });
    }
}

Value VectorEditor::withComponent(int component, double number) const {
    if (const auto* pair = std::get_if<glm::dvec2>(&value_)) {
        glm::dvec2 changed = *pair;
        changed[component] = number;
        return changed;
    }
    glm::dvec3 changed = std::get<glm::dvec3>(value_);
    changed[component] = number;
    return changed;
}

void VectorEditor::present(const Value& value) {
    const std::vector<double> components = componentsOf(value);
    if (components.size() != numbers_.size()) {
        return;
    }
    value_ = value;
    for (std::size_t i = 0; i < components.size(); ++i) {
        numbers_[i]->present(components[i]);
    }
}

QWidget* VectorEditor::focusTarget() {
    return numbers_.empty() ? static_cast<QWidget*>(this) : numbers_.front()->slider();
}

ParameterEditor* makeVec2Editor(const Parameter& parameter, QWidget* parent) {
    return new VectorEditor(parameter, parent);
}

ParameterEditor* makeVec3Editor(const Parameter& parameter, QWidget* parent) {
    return new VectorEditor(parameter, parent);
}

} // namespace patina
