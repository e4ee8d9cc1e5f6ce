// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/neutral_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "catalog/descriptor_checker.h"

namespace patina {
namespace {

using Pointer = nlohmann::json::json_pointer;

/// Holds the conditions of a case as a set, because their order does not matter.
using Conditions = std::set<std::pair<std::string, std::string>>;

bool canBeZero(const Parameter& parameter) {
    return parameter.type == ParameterType::Float || parameter.type == ParameterType::Angle ||
           parameter.type == ParameterType::Color || parameter.type == ParameterType::Vec3;
}

class NeutralChecker : DescriptorChecker {
  public:
    explicit NeutralChecker(const Descriptor& descriptor) : DescriptorChecker(descriptor) {}

    Errors run() {
        const auto found = document_.value.find("neutral");
        if (found != document_.value.end() && found->is_array() && found->empty()) {
            add(Pointer("/neutral"), "this names no case in which the block does nothing",
                "a case such as {\"<id>\": 0}, or no \"neutral\"");
        }
        for (std::size_t i = 0; i < block_.neutral.size(); ++i) {
            for (const NeutralValue& value : block_.neutral[i]) {
                check(Pointer("/neutral") / i / value.id, value);
            }
        }
        if (errors_.empty()) {
            checkRepeats();
            checkChoices();
        }
        return std::move(errors_);
    }

  private:
    void add(const Pointer& place, std::string problem, std::string expected) {
        DescriptorChecker::add(place.to_string(), std::move(problem), std::move(expected));
    }

    /// Returns the values of an enum or an accuracy choice; null for a number.
    const std::vector<EnumValue>* choiceOf(const std::string& id) const {
        if (const AccuracyChoice* choice = block_.accuracyChoice(id)) {
            return &choice->values;
        }
        const Parameter* parameter = block_.parameter(id);
        return parameter != nullptr && infoOf(parameter->type).isChoice ? &parameter->values
                                                                              : nullptr;
    }

    void check(const Pointer& place, const NeutralValue& value) {
        const nlohmann::json& given = document_.value.at(place);
        if (!given.is_string() && given != 0) {
            add(place, "this does not say when the block does nothing",
                "0, a parameter's id, or what is chosen");
        } else if (const std::vector<EnumValue>* values = choiceOf(value.id)) {
            checkWord(place, value.word, *values);
        } else if (const Parameter* parameter = block_.parameter(value.id)) {
            checkNumber(place, *parameter, value.word);
        } else {
            add(place, fmt::format("\"{}\" is not a parameter of the block", value.id),
                "a parameter or an accuracy choice");
        }
    }

    void checkWord(const Pointer& place, const std::string& word,
                   const std::vector<EnumValue>& values) {
        if (std::ranges::find(values, word, &EnumValue::id) == values.end()) {
            add(place, fmt::format("\"{}\" cannot be chosen here", word), "one of its values");
        }
    }

    void checkNumber(const Pointer& place, const Parameter& parameter, const std::string& word) {
        const Parameter* other = block_.parameter(word);
        if (!canBeZero(parameter)) {
            add(place, "only numbers, vectors and colours can be 0", "another parameter");
        } else if (word.empty() && parameter.max <= 0.0) {
            add(place,
                fmt::format("\"{}\" is never above 0: the block would never be there",
                            parameter.id),
                "a parameter that can be above 0");
        } else if (word == parameter.id) {
            add(place,
                fmt::format("\"{}\" is always the same as itself: the block would never be there",
                            word),
                "0, or another parameter");
        } else if (!word.empty() && (other == nullptr || !canBeZero(*other))) {
            add(place, fmt::format("\"{}\" is not a number of the block", word),
                "0, or the parameter that it is the same as");
        }
    }

    Conditions conditionsOf(const NeutralCase& neutral) const {
        Conditions conditions;
        for (const NeutralValue& value : neutral) {
            std::pair condition(value.id, value.word);
            if (choiceOf(value.id) == nullptr && condition.second < condition.first) {
                std::swap(condition.first, condition.second);
            }
            conditions.insert(std::move(condition));
        }
        return conditions;
    }

    /// Reports cases that another case includes; of equal ones it reports the later.
    void checkRepeats() {
        for (std::size_t i = 0; i < block_.neutral.size(); ++i) {
            const Conditions all = conditionsOf(block_.neutral[i]);
            for (std::size_t k = 0; k < block_.neutral.size(); ++k) {
                const Conditions some = conditionsOf(block_.neutral[k]);
                if (k != i && std::ranges::includes(all, some) && (k < i || some != all)) {
                    add(Pointer("/neutral") / i,
                        fmt::format("case {} is enough: this one changes nothing", k + 1),
                        "each case once");
                    break;
                }
            }
        }
    }

    /// Reports an enum all of whose values are cases by themselves: one of them is always chosen.
    void checkChoices() {
        std::map<std::string, std::set<std::string>> chosen;
        for (std::size_t i = 0; i < block_.neutral.size(); ++i) {
            const NeutralCase& neutral = block_.neutral[i];
            const std::vector<EnumValue>* values =
                neutral.size() == 1 ? choiceOf(neutral.front().id) : nullptr;
            if (values == nullptr) {
                continue;
            }
            const std::string& id = neutral.front().id;
            chosen[id].insert(neutral.front().word);
            if (chosen[id].size() == values->size()) {
                add(Pointer("/neutral") / i / id,
                    fmt::format("whatever is chosen for \"{}\", the block would never be there",
                                id),
                    "one value of it that is no case by itself");
            }
        }
    }
};

} // namespace

Errors neutralMistakes(const Descriptor& descriptor) {
    return NeutralChecker(descriptor).run();
}

} // namespace patina
