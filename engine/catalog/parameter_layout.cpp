// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter_layout.h"

#include <algorithm>

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

/// Writes a value, the default where none is given; directions are made unit.
void pack(const Parameter& parameter, const Values& values, double* out) {
    const auto found = values.find(parameter.id);
    writeNumbers(parameter, found == values.end() ? parameter.defaultValue : found->second, out);
    if (isDirection(parameter)) {
        const glm::dvec3 unit = unitDirection({out[0], out[1], out[2]});
        std::copy_n(&unit.x, 3, out);
    }
}

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
            pack(*field.parameter, values, place);
        } else {
            *place = levelOf(*field.choice, levels);
        }
    }
    return out;
}

} // namespace patina
