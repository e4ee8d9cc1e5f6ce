// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/fills.h"

#include <algorithm>

#include "catalog/spectrum.h"

namespace patina {
namespace {

const EnumValue* chosenValue(const Parameter& parameter, const Value& value) {
    const auto* id = std::get_if<std::string>(&value);
    const auto found =
        std::find_if(parameter.values.begin(), parameter.values.end(),
                     [id](const EnumValue& choice) { return id != nullptr && choice.id == *id; });
    return found == parameter.values.end() ? nullptr : &*found;
}

const Value& valueIn(const Values& values, const Parameter& parameter) {
    const auto found = values.find(parameter.id);
    return found == values.end() ? parameter.defaultValue : found->second;
}

/// Tells whether the choice sets nothing, or the values agree with what it sets.
bool tellsTheTruth(const Block& block, const Values& values, const EnumValue* choice) {
    return choice == nullptr ||
           std::all_of(choice->fills.begin(), choice->fills.end(), [&](const auto& fill) {
               const Parameter* filled = block.parameter(fill.first);
               const Value told = roundedToFloat(atSrgbWavelengths(fill.second));
               return filled == nullptr || roundedToFloat(valueIn(values, *filled)) == told;
           });
}

/// Returns the choice of a shorthand that agrees with the values.
Value settled(const Block& block, const Values& values, const Parameter& shorthand) {
    const Value& chosen = valueIn(values, shorthand);
    if (tellsTheTruth(block, values, chosenValue(shorthand, chosen))) {
        return chosen;
    }
    const auto own = std::find_if(shorthand.values.begin(), shorthand.values.end(),
                                  [](const EnumValue& choice) { return choice.fills.empty(); });
    return own == shorthand.values.end() ? chosen : Value(own->id);
}

bool fills(const Parameter& shorthand, std::string_view id) {
    return std::any_of(shorthand.values.begin(), shorthand.values.end(),
                       [id](const EnumValue& choice) { return choice.fills.contains(id); });
}

/// Adds what a choice sets, and the current values of what only its siblings set.
void addFilled(const Block& block, const Values& values, const Parameter& shorthand,
               Values& after) {
    if (const EnumValue* choice = chosenValue(shorthand, after.at(shorthand.id))) {
        for (const auto& [id, value] : choice->fills) {
            after.insert_or_assign(id, roundedToFloat(atSrgbWavelengths(value)));
        }
    }
    for (const Parameter& parameter : block.parameters) {
        if (fills(shorthand, parameter.id)) {
            after.try_emplace(parameter.id, valueIn(values, parameter));
        }
    }
}

} // namespace

bool isShorthand(const Parameter& parameter) {
    return std::any_of(parameter.values.begin(), parameter.values.end(),
                       [](const EnumValue& choice) { return !choice.fills.empty(); });
}

const EnumValue* spectralChoice(const Parameter& parameter, const Values& values) {
    if (!isShorthand(parameter)) {
        return nullptr;
    }
    const EnumValue* choice = chosenValue(parameter, valueIn(values, parameter));
    const bool hasSpectrum =
        choice != nullptr && std::any_of(choice->fills.begin(), choice->fills.end(),
                                         [](const auto& fill) { return spectrumIn(fill.second); });
    return hasSpectrum ? choice : nullptr;
}

Values afterEdit(const Block& block, const Values& values, const Parameter& parameter,
                 const Value& wanted) {
    Values after{{parameter.id, wanted}};
    if (isShorthand(parameter)) {
        addFilled(block, values, parameter, after);
        return after;
    }
    for (const Parameter& shorthand : block.parameters) {
        if (fills(shorthand, parameter.id)) {
            Values all = values;
            all.insert_or_assign(parameter.id, wanted);
            after.insert_or_assign(shorthand.id, settled(block, all, shorthand));
        }
    }
    return after;
}

void fillGaps(const Block& block, Values& given) {
    for (const Parameter& parameter : block.parameters) {
        const auto chosen = given.find(parameter.id);
        const EnumValue* choice =
            chosen == given.end() ? nullptr : chosenValue(parameter, chosen->second);
        if (choice != nullptr) {
            for (const auto& [id, value] : choice->fills) {
                given.try_emplace(id, atSrgbWavelengths(value));
            }
        }
    }
}

void settleShorthands(const Block& block, Values& values) {
    for (const Parameter& parameter : block.parameters) {
        if (isShorthand(parameter)) {
            values.insert_or_assign(parameter.id, settled(block, values, parameter));
        }
    }
}

} // namespace patina
