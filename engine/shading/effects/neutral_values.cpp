// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/neutral_values.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "catalog/index_trend.h"
#include "shading/effects/textures.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Returns the angle of a light's cone where it is 0 and the cone holds nothing; else null.
const Parameter* angleOfNothing(const Block& block, const Values& values) {
    const Parameter* angle = block.reach ? block.parameter(block.reach->angle) : nullptr;
    const bool isNothing =
        angle != nullptr && angle->min >= 0.0 && notPositive(givenValue(*angle, values));
    return isNothing ? angle : nullptr;
}

/// Returns the three parts of a value; the same one thrice of a number. What is not finite or out
/// of range counts as what the program gets, and an index as that at the block's temperature.
glm::dvec3 partsOf(const Block& block, const Parameter& parameter, const Values& values) {
    const Value value = conformed(parameter, givenValue(parameter, values));
    if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        return *triple;
    }
    const auto* given = std::get_if<double>(&value);
    double number = given == nullptr ? 1.0 : *given;
    takeTemperature(block, parameter, values, &number);
    return glm::dvec3(number);
}

bool holds(const NeutralValue& value, const Block& block, const Values& values,
           const AccuracyLevels& levels) {
    if (const AccuracyChoice* choice = block.accuracyChoice(value.id)) {
        return !choice->values.empty() &&
               choice->values[chosenIndex(*choice, levels)].id == value.word;
    }
    const Parameter* parameter = block.parameter(value.id);
    if (parameter != nullptr && infoOf(parameter->type).isChoice) {
        return parameter->values[chosenIndex(*parameter, values)].id == value.word;
    }
    const Parameter* other = value.word.empty() ? nullptr : block.parameter(value.word);
    if (parameter == nullptr || (other == nullptr && !value.word.empty())) {
        return false;
    }
    const glm::dvec3 parts = partsOf(block, *parameter, values);
    return other == nullptr ? notPositive(Value(parts)) : parts == partsOf(block, *other, values);
}

const NeutralCase* neutralCase(const Block& block, const Values& values,
                               const AccuracyLevels& levels) {
    const auto found = std::ranges::find_if(block.neutral, [&](const NeutralCase& neutral) {
        return std::ranges::all_of(neutral, [&](const NeutralValue& value) {
            return holds(value, block, values, levels);
        });
    });
    return found == block.neutral.end() ? nullptr : &*found;
}

std::string quotedLabel(std::string_view label) {
    return fmt::format("“{}”", label);
}

/// "its “Key”, “Fill” and “Top” are 0"; empty for none.
std::string listText(const std::vector<std::string>& labels, const char* what) {
    if (labels.empty()) {
        return {};
    }
    const std::span<const std::string> first(labels.data(), labels.size() - 1);
    return first.empty()
               ? fmt::format("its {} is {}", labels.back(), what)
               : fmt::format("its {} and {} are {}", fmt::join(first, ", "), labels.back(), what);
}

/// "its “Index outside” and “Index inside” are both 1.5".
std::string equalText(const Block& block, const Parameter& one, const Parameter& other,
                      const Values& values) {
    return fmt::format("its {} and {} are both {:.4g}", quotedLabel(one.label),
                       quotedLabel(other.label), partsOf(block, one, values).x);
}

std::string caseText(const NeutralCase& neutral, const Block& block, const Values& values) {
    const Parameter* first = block.parameter(neutral.front().id);
    if (neutral.size() == 1 && first != nullptr && first->role == roles::color) {
        return "It is black.";
    }
    std::vector<std::string> zero;
    std::vector<std::string> less;
    std::vector<std::string> black;
    std::vector<std::string> parts;
    for (const Parameter& parameter : block.parameters) {
        const auto value = std::ranges::find(neutral, parameter.id, &NeutralValue::id);
        if (value == neutral.end() || infoOf(parameter.type).isChoice) {
            continue;
        }
        if (!value->word.empty()) {
            parts.push_back(equalText(block, *block.parameter(value->word), parameter, values));
        } else {
            std::vector<std::string>& signedOrNot = parameter.min < 0.0 ? less : zero;
            (infoOf(parameter.type).isColor ? black : signedOrNot)
                .push_back(quotedLabel(parameter.label));
        }
    }
    for (std::string text :
         {listText(zero, "0"), listText(less, "not above 0"), listText(black, "black")}) {
        if (!text.empty()) {
            parts.push_back(std::move(text));
        }
    }
    std::string sentence = fmt::format("{}.", fmt::join(parts, ", and "));
    sentence.front() =
        static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
    return sentence;
}

} // namespace

bool isNeutral(const Block& block, const Values& values, const AccuracyLevels& levels) {
    return neutralCase(block, values, levels) != nullptr ||
           angleOfNothing(block, values) != nullptr;
}

std::string whyNeutral(const Block& block, const Values& values, const AccuracyLevels& levels) {
    if (const NeutralCase* neutral = neutralCase(block, values, levels)) {
        return caseText(*neutral, block, values);
    }
    const Parameter* angle = angleOfNothing(block, values);
    return angle == nullptr ? std::string()
                            : fmt::format("Its {} is 0.", quotedLabel(angle->label));
}

bool isNeutralPart(const Block& block, const Values& values, const Material& material) {
    const auto isOfKind = [&block, &material](const auto& texture) {
        return texture.first.starts_with(block.kind) && isTextured(texture.first, material);
    };
    return isNeutral(block, values, material.accuracy) &&
           std::ranges::none_of(material.textures, isOfKind);
}

} // namespace patina
