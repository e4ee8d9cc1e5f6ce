// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/fill_checks.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "catalog/descriptor_checker.h"
#include "catalog/fills.h"
#include "catalog/spectrum.h"
#include "catalog/suggestion.h"
#include "catalog/value_json.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// Checks the choices of one parameter that set others.
class FillChecker : DescriptorChecker {
  public:
    FillChecker(const Descriptor& descriptor, std::size_t index)
        : DescriptorChecker(descriptor), parameter_(descriptor.block.parameters[index]),
          pointer_(fmt::format("/parameters/{}", index)) {}

    Errors run() {
        for (std::size_t i = 0; i < parameter_.values.size(); ++i) {
            checkChoice(fmt::format("{}/values/{}/fills", pointer_, i));
        }
        if (isFilling_) {
            checkSets();
            checkOwnChoice();
            checkDefault();
            if (parameter_.compiled != Compiled::No) {
                add(pointer_ + "/compiled", "a choice that sets other parameters is in no shader",
                    "no such key");
            }
        }
        return std::move(errors_);
    }

  private:
    void checkChoice(const std::string& pointer) {
        const Json::json_pointer place(pointer);
        if (!document_.value.contains(place) || !document_.value.at(place).is_object()) {
            return;
        }
        for (const auto& [id, json] : document_.value.at(place).items()) {
            isFilling_ = true;
            all_.insert(id);
            checkFill(id, json, fmt::format("{}/{}", pointer, id));
        }
    }

    void checkFill(const std::string& id, const Json& json, const std::string& pointer) {
        const Parameter* filled = block_.parameter(id);
        if (filled == nullptr || filled == &parameter_) {
            add(pointer, fmt::format("'{}' is no other parameter of this block", id),
                oneOf(id, otherIds()));
            return;
        }
        if (isShorthand(*filled)) {
            add(pointer, fmt::format("'{}' sets other parameters itself", id),
                "a parameter that the shader has");
            return;
        }
        const ValueReading value = fillFromJson(*filled, json);
        if (!value) {
            add(pointer + value.error().within, value.error().problem, value.error().expected);
            return;
        }
        if (spectrumIn(*value) != nullptr) {
            return;
        }
        const Value inRange = conformed(*filled, *value);
        if (inRange != *value) {
            const ValuePart part = broughtIn(*value, inRange);
            add(pointer + part.pointer,
                fmt::format("{} is outside the range of '{}'",
                            part.name.empty() ? "the value" : part.name, id),
                fmt::format("{} to {}", filled->min, filled->max));
        }
    }

    std::vector<std::string> otherIds() const {
        std::vector<std::string> ids;
        for (const Parameter& parameter : block_.parameters) {
            if (&parameter != &parameter_) {
                ids.push_back(parameter.id);
            }
        }
        return ids;
    }

    /// Checks that all choices set the same parameters: one that left a parameter alone would
    /// depend on the choice before.
    void checkSets() {
        for (std::size_t i = 0; i < parameter_.values.size(); ++i) {
            const std::string pointer = fmt::format("{}/values/{}/fills", pointer_, i);
            const Json::json_pointer place(pointer);
            for (const std::string& id : all_) {
                if (document_.value.contains(place) && !document_.value.at(place).contains(id)) {
                    add(pointer, fmt::format("another choice sets '{}', this one does not", id),
                        "the same parameters for each choice");
                }
            }
        }
    }

    void checkOwnChoice() {
        const bool has = std::any_of(parameter_.values.begin(), parameter_.values.end(),
                                     [](const EnumValue& value) { return value.fills.empty(); });
        if (!has) {
            add(pointer_ + "/values", "every choice sets other parameters",
                "one without \"fills\", for values of one's own");
        }
    }

    void checkDefault() {
        Values values = defaultValues(block_);
        settleShorthands(block_, values);
        if (values.at(parameter_.id) != parameter_.defaultValue) {
            add(pointer_ + "/default",
                "the default choice sets values that are not the defaults of their parameters",
                "defaults that agree");
        }
    }

    const Parameter& parameter_;
    std::string pointer_;
    bool isFilling_ = false;
    std::set<std::string> all_;
};

} // namespace

Errors fillMistakes(const Descriptor& descriptor) {
    Errors errors;
    for (std::size_t i = 0; i < descriptor.block.parameters.size(); ++i) {
        const Errors more = FillChecker(descriptor, i).run();
        errors.insert(errors.end(), more.begin(), more.end());
    }
    return errors;
}

} // namespace patina
