// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter_layout.h"

#include <algorithm>

#include "catalog/fills.h"
#include "catalog/index_trend.h"
#include "catalog/unit_direction.h"
#include "catalog/wavelength_ray_choices.h"
#include "catalog/wavelengths.h"

namespace patina {
namespace {

constexpr std::size_t floatsPerVec4 = 4;

std::size_t roundedUp(std::size_t floats) {
    return (floats + floatsPerVec4 - 1) / floatsPerVec4 * floatsPerVec4;
}

/// Returns the offset of the next field, and advances `floats` past it.
std::size_t placed(std::size_t& floats, int components) {
    const auto size = static_cast<std::size_t>(components);
    if (floats % floatsPerVec4 + size > floatsPerVec4) {
        floats = roundedUp(floats);
    }
    const std::size_t offset = floats;
    floats += size;
    return offset;
}

/// Tells whether the program itself reads the parameter, and the block's functions do not.
bool isOfProgram(const Parameter& parameter) {
    return parameter.role == roles::diffuseColor || parameter.role == roles::highlightColor ||
           parameter.role == roles::ambientColor || parameter.role == roles::polarised ||
           parameter.role == roles::fieldDirection || isOfIndexTrend(parameter);
}

/// Calls `ofParameter` and `ofChoice` for the fields in their order, with the offset and size of
/// each, and returns the size of all.
template <class OfParameter, class OfChoice>
std::size_t eachField(const Block& block, OfParameter ofParameter, OfChoice ofChoice) {
    std::size_t floats = 0;
    for (const Parameter& parameter : block.parameters) {
        const int components = componentCount(parameter.type);
        if (components > 0 && !isShorthand(parameter) && !isOfProgram(parameter)) {
            ofParameter(parameter, placed(floats, components), components);
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        if (!isOfProgram(block, choice)) {
            ofChoice(choice, placed(floats, 1));
        }
    }
    return roundedUp(floats);
}

/// Writes a value, the default where none is given; directions are made unit, and an index is that
/// at the temperature of the block.
void pack(const Block& block, const Parameter& parameter, const Values& values, double* out) {
    const auto found = values.find(parameter.id);
    writeNumbers(parameter, found == values.end() ? parameter.defaultValue : found->second, out);
    if (isDirection(parameter)) {
        const glm::dvec3 unit = unitDirection({out[0], out[1], out[2]});
        std::copy_n(&unit.x, 3, out);
    }
    takeWavelengths(parameter, srgbWavelengths, out);
    takeTemperature(block, parameter, values, out);
}

double levelOf(const AccuracyChoice& choice, const AccuracyLevels& levels) {
    const auto found = levels.find(choice.id);
    return found == levels.end() ? 0.0 : static_cast<double>(indexOf(choice.values, found->second));
}

} // namespace

const ParameterField* ParameterLayout::withRole(std::string_view role) const {
    const auto found = std::ranges::find_if(fields, [role](const ParameterField& field) {
        return field.parameter != nullptr && field.parameter->role == role;
    });
    return found == fields.end() ? nullptr : &*found;
}

ParameterLayout layoutOf(const Block& block) {
    ParameterLayout layout;
    layout.floats = eachField(
        block,
        [&layout](const Parameter& parameter, std::size_t offset, int components) {
            layout.fields.push_back(
                {&parameter, nullptr, fieldName(parameter.id), offset, components});
        },
        [&layout](const AccuracyChoice& choice, std::size_t offset) {
            layout.fields.push_back({nullptr, &choice, fieldName(choice.id), offset, 1});
        });
    return layout;
}

std::vector<double> packed(const Block& block, const Values& values, const AccuracyLevels& levels) {
    std::vector<double> out;
    const auto at = [&out](std::size_t offset, int components) {
        out.resize(offset + static_cast<std::size_t>(components));
        return out.data() + offset;
    };
    const std::size_t size = eachField(
        block,
        [&](const Parameter& parameter, std::size_t offset, int components) {
            pack(block, parameter, values, at(offset, components));
        },
        [&](const AccuracyChoice& choice, std::size_t offset) {
            *at(offset, 1) = levelOf(choice, levels);
        });
    out.resize(size);
    return out;
}

} // namespace patina
