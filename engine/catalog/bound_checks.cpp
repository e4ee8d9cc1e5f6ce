// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/bound_checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/suggestion.h"

namespace patina {
namespace {

class BoundChecker {
  public:
    explicit BoundChecker(const Descriptor& descriptor)
        : block_(descriptor.block), document_(descriptor.document) {}

    Errors run() {
        if (block_.hides) {
            checkHiding(*block_.hides);
        }
        if (block_.reach) {
            checkReach(*block_.reach);
        }
        for (std::size_t i = 0; i < block_.neutral.size(); ++i) {
            for (const NeutralValue& value : block_.neutral[i]) {
                const auto place = nlohmann::json::json_pointer("/neutral") / i / value.id;
                checkNeutral(place, value);
            }
        }
        return std::move(errors_);
    }

  private:
    void add(const std::string& pointer, std::string problem, std::string expected) {
        errors_.push_back(document_.error(pointer, std::move(problem), std::move(expected)));
    }

    void checkHiding(const Hiding& hiding) {
        const bool isRate = !hiding.rate.empty();
        if (isRate == !hiding.from.empty() || isRate == !hiding.to.empty()) {
            add("/hides", "this does not say how much is hidden",
                "either \"rate\", or \"from\" and \"to\"");
            return;
        }
        for (const auto& [key, id] :
             {std::pair{"rate", &hiding.rate}, std::pair{"from", &hiding.from},
              std::pair{"to", &hiding.to}}) {
            checkType(fmt::format("/hides/{}", key), *id, ParameterType::Float, Space::None);
        }
        if (hiding.base.empty() != hiding.thickness.empty() || (!isRate && !hiding.base.empty())) {
            add("/hides", "a rate that falls with height has a base and a thickness",
                "\"rate\", \"base\" and \"thickness\"");
        }
        checkType("/hides/base", hiding.base, ParameterType::Float, Space::None);
        checkType("/hides/thickness", hiding.thickness, ParameterType::Float, Space::None);
    }

    void checkReach(const Reach& reach) {
        checkType("/reach/from", reach.from, ParameterType::Vec3, Space::WorldPoint);
        checkType("/reach/range", reach.range, ParameterType::Float, Space::None);
        checkType("/reach/axis", reach.axis, ParameterType::Vec3, Space::WorldDirection);
        checkType("/reach/angle", reach.angle, ParameterType::Angle, Space::None);
        if (reach.axis.empty() != reach.angle.empty()) {
            add("/reach", "a cone has an axis and an angle", "both of them or neither");
        }
    }

    void checkNeutral(const nlohmann::json::json_pointer& place, const NeutralValue& value) {
        const std::string pointer = place.to_string();
        const AccuracyChoice* choice = block_.accuracyChoice(value.id);
        const Parameter* parameter = block_.parameter(value.id);
        const nlohmann::json& given = document_.value.at(place);
        if (!given.is_string() && given != 0) {
            add(pointer, "this does not say when the block does nothing",
                "0, a parameter's id, or what is chosen");
        } else if (choice == nullptr && parameter == nullptr) {
            add(pointer, fmt::format("\"{}\" is not a parameter of the block", value.id),
                "a parameter or an accuracy choice");
        } else if (choice != nullptr || parameter->type == ParameterType::Enum) {
            checkWord(pointer, value.word, choice != nullptr ? choice->values : parameter->values);
        } else if (!isNumeric(*parameter)) {
            add(pointer, "only numbers, vectors and colours can be 0", "another parameter");
        } else if (!value.word.empty() && (block_.parameter(value.word) == nullptr ||
                                           !isNumeric(*block_.parameter(value.word)))) {
            add(pointer, fmt::format("\"{}\" is not a number of the block", value.word),
                "0, or the parameter that it is the same as");
        }
    }

    void checkWord(const std::string& pointer, const std::string& word,
                   const std::vector<EnumValue>& values) {
        if (std::ranges::find(values, word, &EnumValue::id) == values.end()) {
            add(pointer, fmt::format("\"{}\" cannot be chosen here", word), "one of its values");
        }
    }

    static bool isNumeric(const Parameter& parameter) {
        return parameter.type == ParameterType::Float || parameter.type == ParameterType::Angle ||
               parameter.type == ParameterType::Color || parameter.type == ParameterType::Vec3;
    }

    void checkType(const std::string& pointer, const std::string& id, ParameterType type,
                   Space space) {
        if (id.empty()) {
            return;
        }
        std::vector<std::string> known;
        for (const Parameter& parameter : block_.parameters) {
            if (parameter.type == type && parameter.space == space) {
                known.push_back(parameter.id);
            }
        }
        const Parameter* parameter = block_.parameter(id);
        if (parameter == nullptr || parameter->type != type || parameter->space != space) {
            add(pointer, fmt::format("\"{}\" is not the parameter that is needed here", id),
                known.empty() ? "a parameter of the right type and space" : oneOf(id, known));
        }
    }

    const Block& block_;
    const LocatedJson& document_;
    Errors errors_;
};

} // namespace

Errors boundMistakes(const Descriptor& descriptor) {
    return BoundChecker(descriptor).run();
}

} // namespace patina
