// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter_layout.h"

#include <glm/trigonometric.hpp>

#include "catalog/fills.h"
#include "catalog/unit_direction.h"

namespace patina {
namespace {

constexpr std::size_t floatsPerVec4 = 4;

std::size_t roundedUp(std::size_t floats) {
    return (floats + floatsPerVec4 - 1) / floatsPerVec4 * floatsPerVec4;
}

void append(ParameterLayout& layout, ParameterField field) {
    const auto size = static_cast<std::size_t>(field.components);
    if (layout.floats % floatsPerVec4 + size > floatsPerVec4) {
        layout.floats = roundedUp(layout.floats);
    }
    field.offset = layout.floats;
    layout.floats += size;
    layout.fields.push_back(std::move(field));
}

Value valueOf(const Parameter& parameter, const Values& values) {
    const auto found = values.find(parameter.id);
    return found == values.end() ? parameter.defaultValue : conformed(parameter, found->second);
}

/// Writes the components of a value; `out` has room for three.
struct Packer {
    const Parameter& parameter;
    double* out;

    void operator()(bool value) const { *out = value ? 1.0 : 0.0; }
    void operator()(int value) const { *out = value; }
    void operator()(double value) const {
        *out = parameter.type == ParameterType::Angle ? glm::radians(value) : value;
    }
    void operator()(const glm::dvec2& value) const {
        out[0] = value.x;
        out[1] = value.y;
    }
    void operator()(const glm::dvec3& value) const {
        const glm::dvec3 inUse = isDirection(parameter) ? unitDirection(value) : value;
        (*this)(glm::dvec2(inUse));
        out[2] = inUse.z;
    }
    void operator()(const std::string& value) const {
        *out = static_cast<double>(indexOf(parameter.values, value));
    }
};

double levelOf(const AccuracyChoice& choice, const AccuracyLevels& levels) {
    const auto found = levels.find(choice.id);
    return found == levels.end() ? 0.0 : static_cast<double>(indexOf(choice.values, found->second));
}

} // namespace

ParameterLayout layoutOf(const Block& block) {
    ParameterLayout layout;
    for (const Parameter& parameter : block.parameters) {
        const int components = componentCount(parameter.type);
        if (components > 0 && !isShorthand(parameter)) {
            append(layout, {&parameter, nullptr, fieldName(parameter.id), 0, components});
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        append(layout, {nullptr, &choice, fieldName(choice.id), 0, 1});
    }
    layout.floats = roundedUp(layout.floats);
    return layout;
}

std::vector<double> packed(const Block& block, const Values& values, const AccuracyLevels& levels) {
    const ParameterLayout layout = layoutOf(block);
    std::vector<double> out(layout.floats, 0.0);
    for (const ParameterField& field : layout.fields) {
        double* place = out.data() + field.offset;
        if (field.parameter != nullptr) {
            std::visit(Packer{*field.parameter, place}, valueOf(*field.parameter, values));
        } else {
            *place = levelOf(*field.choice, levels);
        }
    }
    return out;
}

} // namespace patina
