// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/match/free_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "catalog/block_kind.h"
#include "catalog/expression.h"

namespace patina {
namespace {

/// Bounds how many lengths of the slider a fit goes beyond its ends.
constexpr double maxBeyond = 20.0;

bool isLog(const Parameter& parameter) {
    return parameter.scale == Scale::Log && parameter.softMin > 0.0;
}

double onSlider(const Parameter& parameter, double value) {
    if (isLog(parameter)) {
        return std::log(std::max(value, parameter.softMin * 1e-6) / parameter.softMin) /
               std::log(parameter.softMax / parameter.softMin);
    }
    return (value - parameter.softMin) / (parameter.softMax - parameter.softMin);
}

double fromSlider(const Parameter& parameter, double place) {
    if (isLog(parameter)) {
        return parameter.softMin * std::pow(parameter.softMax / parameter.softMin, place);
    }
    return parameter.softMin + place * (parameter.softMax - parameter.softMin);
}

int numbersIn(const Value& value) {
    if (std::holds_alternative<double>(value)) {
        return 1;
    }
    if (std::holds_alternative<glm::dvec2>(value)) {
        return 2;
    }
    return std::holds_alternative<glm::dvec3>(value) ? 3 : 0;
}

double& numberOf(Value& value, int component) {
    if (auto* vector = std::get_if<glm::dvec3>(&value)) {
        return (*vector)[component];
    }
    if (auto* pair = std::get_if<glm::dvec2>(&value)) {
        return (*pair)[component];
    }
    return std::get<double>(value);
}

/// Tells whether a parameter says where in a pattern is looked: a reflectance is its average.
bool isOfPattern(const Parameter& parameter) {
    constexpr std::array ofPattern{roles::coordinates, roles::coordinatesRight,
                                   roles::coordinatesUp, roles::patternWidth};
    return std::ranges::find(ofPattern, parameter.role) != ofPattern.end();
}

bool mayChange(const Parameter& parameter) {
    return infoOf(parameter.type).isContinuous && parameter.softMax > parameter.softMin &&
           !parameter.emission && parameter.compiled != Compiled::Yes && !isOfPattern(parameter);
}

Value& valueOf(EvalCase& model, bool isOfSlot, const Parameter& parameter) {
    EvalBlock& block = isOfSlot ? model.slot : model.block;
    return block.values.try_emplace(parameter.id, parameter.defaultValue).first->second;
}

/// Tells whether a condition is about a number of the block that may change.
bool isOnFreeNumber(const Expression& condition, const Block& block) {
    return std::ranges::any_of(condition.comparisons(), [&block](const auto& comparison) {
        return std::ranges::any_of(block.parameters, [&comparison](const Parameter& parameter) {
            return mayChange(parameter) &&
                   (parameter.id == comparison.left || parameter.id == comparison.right);
        });
    });
}

} // namespace

bool counts(const Parameter& parameter, const EvalBlock& block) {
    const Result<Expression> condition = Expression::parse(parameter.enabledWhen);
    if (!condition || isOnFreeNumber(*condition, *block.block)) {
        return true;
    }
    Values values = block.values;
    values.merge(defaultValues(*block.block));
    return condition->evaluate(values);
}

FreeNumbers::FreeNumbers(const EvalCase& model, const std::vector<std::string>& only) {
    add(model.block, false, only);
    if (model.slot.block != nullptr) {
        add(model.slot, true, only);
    }
}

void FreeNumbers::add(const EvalBlock& block, bool isOfSlot, const std::vector<std::string>& only) {
    const std::string prefix = isOfSlot ? block.block->kind + '.' : std::string();
    for (const Parameter& parameter : block.block->parameters) {
        const bool isFree =
            mayChange(parameter) && counts(parameter, block) &&
            (only.empty() || std::ranges::find(only, prefix + parameter.id) != only.end());
        const int count = isFree ? numbersIn(parameter.defaultValue) : 0;
        for (int component = 0; component < count; ++component) {
            numbers_.push_back({isOfSlot, &parameter, component,
                                std::max(onSlider(parameter, parameter.min), -maxBeyond),
                                std::min(onSlider(parameter, parameter.max), 1.0 + maxBeyond)});
        }
    }
}

std::vector<double> FreeNumbers::of(const EvalCase& model) const {
    EvalCase copy = model;
    std::vector<double> values;
    for (const Number& number : numbers_) {
        const double value =
            numberOf(valueOf(copy, number.isOfSlot, *number.parameter), number.component);
        values.push_back(std::clamp(onSlider(*number.parameter, value), number.min, number.max));
    }
    return values;
}

void FreeNumbers::set(EvalCase& model, const double* values) const {
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const Number& number = numbers_[i];
        numberOf(valueOf(model, number.isOfSlot, *number.parameter), number.component) = std::clamp(
            fromSlider(*number.parameter, values[i]), number.parameter->min, number.parameter->max);
    }
}

} // namespace patina
