// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/descriptor_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "catalog/block_kind.h"
#include "catalog/bound_checks.h"
#include "catalog/combing_role.h"
#include "catalog/descriptor_checker.h"
#include "catalog/expression.h"
#include "catalog/fill_checks.h"
#include "catalog/look_checks.h"
#include "catalog/neutral_checks.h"
#include "catalog/reserved_words.h"
#include "catalog/role_checks.h"
#include "catalog/shadow_checks.h"
#include "catalog/suggestion.h"
#include "catalog/table_checks.h"
#include "catalog/value_json.h"
#include "core/number_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

std::vector<std::string> idsOf(const std::vector<EnumValue>& values) {
    std::vector<std::string> ids;
    for (const EnumValue& value : values) {
        ids.push_back(value.id);
    }
    return ids;
}

/// Collects the mistakes of one descriptor, each at its place.
class Checker : DescriptorChecker {
  public:
    explicit Checker(const Descriptor& descriptor) : DescriptorChecker(descriptor) {}

    Errors run() {
        checkFiles();
        checkSlots();
        checkParameters();
        for (std::size_t i = 0; i < block_.accuracy.size(); ++i) {
            checkAccuracy(block_.accuracy[i], fmt::format("/accuracy/{}", i));
        }
        checkClaims();
        return std::move(errors_);
    }

  private:
    bool has(const std::string& pointer) const { return document_.places.contains(pointer); }

    void checkFiles() {
        const std::string stem = block_.descriptorFile.stem().string();
        if (!block_.id.empty() && block_.id != stem) {
            add("/id", fmt::format("the id \"{}\" is not the file's name", block_.id),
                fmt::format("\"{}\"", stem));
        }
        if (const std::string name = block_.id.empty() ? std::string() : functionName(block_);
            isReservedWord(name) || name == "main") {
            add("/id", fmt::format("the block's function would be \"{}\", which is taken", name),
                "another id");
        }
        std::error_code status;
        if (!isOfSettings() && !std::filesystem::is_regular_file(block_.shaderFile, status)) {
            add("", "the block has no shader",
                "a file " + block_.shaderFile.filename().string() + " beside this one");
        }
    }

    /// Tells whether the block is of settings, which have no shader, and declare a material's own
    /// images.
    bool isOfSettings() const { return block_.shaderFile.empty(); }

    void checkSlots() {
        std::set<std::string> kinds;
        for (std::size_t i = 0; i < block_.slots.size(); ++i) {
            if (!kinds.insert(block_.slots[i].kind).second) {
                add(fmt::format("/slots/{}/kind", i),
                    fmt::format("there are two slots for {}", block_.slots[i].kind),
                    "each kind once");
            }
        }
    }

    void checkParameters() {
        std::set<std::string> ids;
        std::set<std::string> fields;
        for (std::size_t i = 0; i < block_.parameters.size(); ++i) {
            const Parameter& parameter = block_.parameters[i];
            const std::string pointer = fmt::format("/parameters/{}", i);
            checkName(parameter.id, pointer, ids, fields);
            checkParameter(parameter, pointer);
        }
        for (std::size_t i = 0; i < block_.accuracy.size(); ++i) {
            checkName(block_.accuracy[i].id, fmt::format("/accuracy/{}", i), ids, fields);
        }
    }

    void checkName(const std::string& id, const std::string& pointer, std::set<std::string>& ids,
                   std::set<std::string>& fields) {
        if (id.empty()) {
            return;
        }
        if (!ids.insert(id).second) {
            add(pointer + "/id", fmt::format("the id \"{}\" occurs twice", id), "each id once");
        } else if (const std::string field = fieldName(id); !fields.insert(field).second) {
            add(pointer + "/id", fmt::format("another id also makes the field \"{}\"", field),
                "ids that differ in more than dots");
        } else if (isReservedWord(field)) {
            add(pointer + "/id", fmt::format("\"{}\" is a word of GLSL or C++", field),
                "another id");
        } else if (block_.slot(field) != nullptr) {
            add(pointer + "/id", fmt::format("\"{}\" is the name of the block's slot", field),
                "another id");
        }
    }

    void checkParameter(const Parameter& parameter, const std::string& pointer) {
        if (infoOf(parameter.type).hasRange) {
            checkRange(parameter, pointer);
        }
        if (infoOf(parameter.type).isChoice) {
            checkValues(parameter.values, pointer + "/values");
        } else if (has(pointer + "/values")) {
            add(pointer + "/values", "only an enum has values", "no such key");
        }
        checkParkedKey(parameter, pointer + "/id");
        checkDefault(parameter, pointer);
        checkComponents(parameter, pointer + "/components");
        checkCompiled(parameter, pointer + "/compiled");
        checkCondition(parameter, pointer + "/enabledWhen");
        checkPhysical(parameter, pointer + "/physical");
        checkMigrations(parameter, pointer + "/migrations");
        if (parameter.space != Space::None && parameter.type != ParameterType::Vec3) {
            add(pointer + "/space", "only a vec3 lies in a space", "no such key");
        }
        if (parameter.emission && !infoOf(parameter.type).isColor) {
            add(pointer + "/emission", "only a colour can be emitted", "no such key");
        }
        checkTexture(parameter, pointer);
    }

    /// Refuses ids under which presets keep objects beside the resting values: a value that is an
    /// object would be taken for one of them.
    void checkParkedKey(const Parameter& parameter, const std::string& pointer) {
        constexpr auto taken = std::to_array<std::string_view>({"black", "inSlot", "withoutSlot"});
        const bool isTaken = std::ranges::find(taken, parameter.id) != taken.end() ||
                             findKind(parameter.id) != nullptr;
        if (isTaken && infoOf(parameter.type).toJson != nullptr) {
            add(pointer, fmt::format("\"{}\" is a key of presets", parameter.id), "another id");
        }
    }

    /// Checks the images of a parameter: an image drives what is read at every point, and three
    /// keys of a preset's images have a meaning of their own.
    void checkTexture(const Parameter& parameter, const std::string& pointer) {
        constexpr std::array<std::string_view, 3> taken{"normal", "height", "opacity"};
        if (parameter.textureChannels.empty() || isOfSettings()) {
            return;
        }
        const bool takesImage =
            infoOf(parameter.type).takesImage || parameter.role == roles::combing;
        if (!takesImage ||
            (parameter.compiled != Compiled::No && parameter.compiled != Compiled::WhenEqual)) {
            add(pointer + "/texture",
                "only a float or a colour that is not compiled in takes an image", "no such key");
        } else if (std::find(taken.begin(), taken.end(), parameter.id) != taken.end()) {
            add(pointer + "/texture",
                fmt::format("\"{}\" is the key of a whole material's image", parameter.id),
                "another id, or no such key");
        }
    }

    void checkRange(const Parameter& parameter, const std::string& pointer) {
        const bool needsRange = infoOf(parameter.type).needsRange;
        for (const char* key : {"/min", "/max"}) {
            if (needsRange && has(pointer + "/type") && !has(pointer + key)) {
                add(pointer, fmt::format("the key \"{}\" is missing", key + 1), "a number");
            }
        }
        if (parameter.min > parameter.max) {
            add(pointer + "/min", "min is above max",
                fmt::format("a number up to {}", shortestFloatText(parameter.max)));
        } else if (parameter.softMin < parameter.min || parameter.softMax > parameter.max ||
                   parameter.softMin > parameter.softMax) {
            add(pointer + (parameter.softMin < parameter.min ? "/softMin" : "/softMax"),
                "the soft range is not inside the hard range",
                fmt::format("{} <= softMin <= softMax <= {}", shortestFloatText(parameter.min),
                            shortestFloatText(parameter.max)));
        }
        checkWholeRange(parameter, pointer);
        if (parameter.scale == Scale::Log && parameter.softMin <= 0.0) {
            add(pointer + "/scale", "a log slider cannot reach 0", "a softMin above 0");
        }
    }

    /// Checks the range of integers: values reach the shader as floats, which hold every whole
    /// number up to 2^24.
    void checkWholeRange(const Parameter& parameter, const std::string& pointer) {
        constexpr double largest = 1 << 24;
        for (const auto& [key, value] :
             {std::pair{"/min", parameter.min}, {"/max", parameter.max}}) {
            if (infoOf(parameter.type).isWhole && std::abs(value) > largest) {
                add(pointer + key, "a float cannot hold every whole number of this size",
                    "a number from -16777216 to 16777216");
            }
        }
    }

    void checkComponents(const Parameter& parameter, const std::string& pointer) {
        const bool isVector = !componentNames(parameter).empty();
        const auto count = static_cast<std::size_t>(componentCount(parameter.type));
        if (has(pointer) && !isVector) {
            add(pointer, "only a vec2 or a vec3 has components", "no such key");
        } else if (has(pointer) && parameter.components.size() != count) {
            add(pointer, fmt::format("{} names for {} numbers", parameter.components.size(), count),
                "a name for each");
        }
    }

    void checkPhysical(const Parameter& parameter, const std::string& pointer) {
        if (parameter.physical && parameter.physical->min > parameter.physical->max) {
            add(pointer + "/min", "min is above max",
                fmt::format("a number up to {}", shortestFloatText(parameter.physical->max)));
        }
    }

    void checkMigrations(const Parameter& parameter, const std::string& pointer) {
        for (std::size_t i = 0; i < parameter.migrations.size(); ++i) {
            const std::string& from = parameter.migrations[i].from;
            if (block_.parameter(from) != nullptr) {
                add(fmt::format("{}/{}/from", pointer, i),
                    fmt::format("\"{}\" is the id of a parameter", from),
                    "an id that is no longer used");
            }
        }
    }

    void checkValues(const std::vector<EnumValue>& values, const std::string& pointer) {
        if (values.empty()) {
            add(pointer, "an enum has choices", "an array of values");
        }
        std::set<std::string> seen;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!values[i].id.empty() && !seen.insert(values[i].id).second) {
                add(fmt::format("{}/{}/id", pointer, i),
                    fmt::format("the id \"{}\" occurs twice", values[i].id), "each id once");
            }
        }
    }

    void checkDefault(const Parameter& parameter, const std::string& pointer) {
        const Json* json = member(pointer, "default");
        const bool isChosen = infoOf(parameter.type).isChoice;
        if (json == nullptr || !has(pointer + "/type") || (isChosen && parameter.values.empty())) {
            return;
        }
        const ValueReading value = valueFromJson(parameter, *json);
        if (!value) {
            add(pointer + "/default" + value.error().within, value.error().problem,
                value.error().expected);
            return;
        }
        const Value inRange = conformed(parameter, *value);
        if (parameter.min <= parameter.max && inRange != *value) {
            const ValuePart part = broughtIn(*value, inRange);
            add(pointer + "/default" + part.pointer,
                part.name + (part.name.empty() ? "" : " of ") +
                    "the default is outside the hard range",
                fmt::format("{} to {}", shortestFloatText(parameter.min),
                            shortestFloatText(parameter.max)));
        }
    }

    const Json* member(const std::string& pointer, const char* key) const {
        const Json::json_pointer place(pointer + '/' + key);
        return document_.value.contains(place) ? &document_.value.at(place) : nullptr;
    }

    void checkCompiled(const Parameter& parameter, const std::string& pointer) {
        const bool hasStates = infoOf(parameter.type).states != nullptr;
        if (parameter.compiled == Compiled::Yes && !hasStates) {
            add(pointer, "only an enum or a bool can be compiled in",
                "false, or \"whenZero\" for a float");
        } else if (parameter.compiled == Compiled::WhenZero &&
                   parameter.type != ParameterType::Float) {
            add(pointer, "only a float can be left out while it is zero", "true or false");
        } else if (parameter.compiled == Compiled::WhenEqual) {
            checkEqual(parameter, pointer);
        }
    }

    void checkEqual(const Parameter& parameter, const std::string& pointer) {
        const Parameter* other = block_.parameter(parameter.equalTo);
        if (parameter.type != ParameterType::Float || other == nullptr || other == &parameter ||
            other->type != ParameterType::Float) {
            add(pointer, "only two floats of a block can be the same", "the id of another float");
        }
        if (block_.parameter(parameter.id + ".equal") != nullptr) {
            add(pointer, fmt::format("\"{}.equal\" is taken", parameter.id), "another id there");
        }
    }

    void checkCondition(const Parameter& parameter, const std::string& pointer) {
        const Result<Expression> expression = Expression::parse(parameter.enabledWhen);
        if (!expression) {
            add(pointer,
                fmt::format("{} (column {} of the text)", expression.error().problem,
                            expression.error().column),
                expression.error().expected);
            return;
        }
        for (const Expression::Comparison& comparison : expression->comparisons()) {
            checkComparison(parameter, comparison, pointer);
        }
    }

    void checkComparison(const Parameter& owner, const Expression::Comparison& comparison,
                         const std::string& pointer) {
        const Parameter* left = block_.parameter(comparison.left);
        if (left == nullptr || left == &owner) {
            std::vector<std::string> siblings;
            for (const Parameter& parameter : block_.parameters) {
                if (&parameter != &owner) {
                    siblings.push_back(parameter.id);
                }
            }
            add(pointer, fmt::format("'{}' is no other parameter of this block", comparison.left),
                oneOf(comparison.left, siblings));
            return;
        }
        if (componentCount(left->type) != 1) {
            add(pointer, fmt::format("'{}' is not a single value", left->id),
                "a number, a bool or an enum");
        } else if (!isComparable(*left, comparison.right)) {
            add(pointer, fmt::format("'{}' is nothing '{}' can be", comparison.right, left->id),
                infoOf(left->type).isChoice ? oneOf(comparison.right, idsOf(left->values))
                                            : "a number, true, false or a parameter");
        }
    }

    bool isComparable(const Parameter& left, const std::string& right) const {
        if (right.empty() || block_.parameter(right) != nullptr) {
            return true;
        }
        if (infoOf(left.type).isChoice) {
            const std::vector<std::string> ids = idsOf(left.values);
            return std::find(ids.begin(), ids.end(), right) != ids.end();
        }
        return parseNumber(right) || right == "true" || right == "false";
    }

    void checkAccuracy(const AccuracyChoice& choice, const std::string& pointer) {
        checkValues(choice.values, pointer + "/values");
        for (std::size_t i = 0; i < choice.values.size(); ++i) {
            if (choice.values[i].exact != (i == 0)) {
                add(fmt::format("{}/values/{}", pointer, i),
                    i == 0 ? "the first level is not marked as exact"
                           : "a level after the first is marked as exact",
                    "\"exact\": true on the first level only");
            }
        }
    }

    void checkClaims() {
        for (const std::string& claim : block_.claims) {
            if (block_.exemptions.contains(claim)) {
                add("/exemptions/" + claim, fmt::format("\"{}\" is also claimed", claim),
                    "either a claim or an exemption");
            }
        }
    }
};

} // namespace

Errors descriptorMistakes(const Descriptor& descriptor) {
    Errors errors = Checker(descriptor).run();
    if (descriptor.block.lighting != LightsWanted::All && descriptor.block.kind != kinds::models) {
        errors.push_back(
            descriptor.document.error("/lighting", "only a model is lit", "no such key"));
    }
    for (const Errors& more :
         {fillMistakes(descriptor), shadowMistakes(descriptor), boundMistakes(descriptor),
          neutralMistakes(descriptor), tableMistakes(descriptor), roleMistakes(descriptor),
          lookMistakes(descriptor)}) {
        errors.insert(errors.end(), more.begin(), more.end());
    }
    return errors;
}

Errors slotMistakes(const Descriptor& descriptor, const IdsOfKind& idsOfKind) {
    Errors errors;
    for (std::size_t i = 0; i < descriptor.block.slots.size(); ++i) {
        const Slot& slot = descriptor.block.slots[i];
        const std::vector<std::string> ids = idsOfKind(slot.kind);
        if (!slot.defaultBlock.empty() && std::ranges::find(ids, slot.defaultBlock) == ids.end()) {
            errors.push_back(descriptor.document.error(
                fmt::format("/slots/{}/default", i),
                fmt::format("there is no {} block \"{}\"", slot.kind, slot.defaultBlock),
                oneOf(slot.defaultBlock, ids)));
        }
    }
    return errors;
}

} // namespace patina
