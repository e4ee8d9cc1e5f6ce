// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/given_value.h"

namespace patina {

const Value& givenValue(const Parameter& parameter, const Values& values) {
    const auto found = values.find(parameter.id);
    const bool usable =
        found != values.end() && found->second.index() == parameter.defaultValue.index();
    return usable ? found->second : parameter.defaultValue;
}

bool notPositive(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return !(*number > 0.0);
    }
    if (const auto* whole = std::get_if<int>(&value)) {
        return *whole <= 0;
    }
    if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        return !(triple->x > 0.0 || triple->y > 0.0 || triple->z > 0.0);
    }
    return false;
}

std::size_t chosenIndex(const Parameter& parameter, const Values& values) {
    return infoOf(parameter.type).state(parameter, givenValue(parameter, values));
}

std::size_t chosenIndex(const AccuracyChoice& choice, const AccuracyLevels& levels) {
    const auto found = levels.find(choice.id);
    return found == levels.end() ? 0 : indexOf(choice.values, found->second);
}

bool isZero(const Parameter& parameter, const Values& values) {
    const Value& value = givenValue(parameter, values);
    const auto* number = std::get_if<double>(&value);
    return number != nullptr && *number == 0.0;
}

std::size_t compiledState(const Block& block, const Parameter& parameter, const Values& values) {
    if (parameter.compiled == Compiled::WhenZero) {
        return isZero(parameter, values) ? 0 : 1;
    }
    if (parameter.compiled == Compiled::WhenEqual) {
        const Parameter* other = block.parameter(parameter.equalTo);
        return other != nullptr && givenValue(parameter, values) == givenValue(*other, values) ? 0
                                                                                               : 1;
    }
    return chosenIndex(parameter, values);
}

} // namespace patina
