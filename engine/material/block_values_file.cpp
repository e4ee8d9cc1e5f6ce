// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/block_values.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "catalog/fills.h"
#include "catalog/suggestion.h"
#include "catalog/value_json.h"
#include "material/accuracy_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::size_t maxNotes = 20; ///< limits notes about one block's unknown keys

/// Guesses a value from its JSON alone, for blocks without a descriptor. Nothing is returned where
/// writing the value would not give the same JSON.
std::optional<Value> guessed(const Json& json) {
    Parameter parameter;
    const std::size_t size = json.is_array() ? json.size() : 0;
    if (json.is_boolean()) {
        parameter.type = ParameterType::Bool;
    } else if (json.is_number_integer()) {
        parameter.type = ParameterType::Int;
    } else if (json.is_string()) {
        parameter.type = ParameterType::Texture;
    } else if (size == 2 || size == 3) {
        parameter.type = size == 2 ? ParameterType::Vec2 : ParameterType::Vec3;
    }
    const ValueReading value = valueFromJson(parameter, json);
    if (!value || toJson(*value) != json) {
        return std::nullopt;
    }
    return *value;
}

/// Reads the values of one block, whose descriptor is known or not.
class ValuesReader {
  public:
    ValuesReader(JsonReader& reader, BlockValues& values, Errors& notes, Json& parked)
        : reader_(reader), values_(values), notes_(notes), parked_(parked) {}

    void readAsTheyCome() {
        const Json all = reader_.unknown();
        for (const auto& [id, json] : all.items()) {
            if (const auto value = guessed(json)) {
                values_.parameters[id] = *value;
            } else {
                keepUnknown(id, json);
            }
        }
    }

    void read(const Block& block) {
        readKnown(block);
        std::vector<std::string> ids;
        for (const Parameter& parameter : block.parameters) {
            ids.push_back(parameter.id);
        }
        const Json unknown = reader_.unknown();
        std::size_t noted = 0;
        for (const auto& [id, json] : unknown.items()) {
            if (++noted <= maxNotes) {
                note(
                    id,
                    fmt::format("{} has no parameter \"{}\"; it is kept as it is", block.label, id),
                    oneOf(id, ids));
            }
            keepUnknown(id, json);
        }
    }

  private:
    void note(const std::string& id, std::string problem, std::string expected,
              const std::string& within = {}) {
        notes_.push_back(reader_.document().error(reader_.pointer(id) + within, std::move(problem),
                                                  std::move(expected)));
    }

    void keepUnknown(const std::string& id, const Json& json) {
        values_.unknown["parameters"][id] = json;
    }

    /// Reads the block's parameters. A choice that sets others sets those that the file does not
    /// have.
    void readKnown(const Block& block) {
        Values given;
        for (const Parameter& parameter : block.parameters) {
            const Value value = valueOf(parameter);
            values_.parameters[parameter.id] = value;
            if (reader_.has(idInFile(parameter))) {
                given.emplace(parameter.id, value);
            }
        }
        fillGaps(block, given);
        for (const auto& [id, value] : given) {
            values_.parameters[id] = roundedToFloat(value);
        }
        settleShorthands(block, values_.parameters);
    }

    /// Returns the id under which the file has the parameter: its own, or one that it had when the
    /// file was written.
    std::string idInFile(const Parameter& parameter) {
        if (!reader_.has(parameter.id)) {
            for (const Migration& migration : parameter.migrations) {
                if (values_.version <= migration.until && reader_.has(migration.from)) {
                    return migration.from;
                }
            }
        }
        return parameter.id;
    }

    Value valueOf(const Parameter& parameter) {
        const std::string id = idInFile(parameter);
        const Json* json = reader_.find(id);
        if (json == nullptr) {
            return roundedToFloat(parameter.defaultValue);
        }
        const ValueReading value = valueFromJson(parameter, *json);
        if (!value) {
            return refused(parameter, id, *json, value.error());
        }
        const Value inRange = conformed(parameter, *value);
        if (inRange != *value) {
            const ValuePart part = broughtIn(*value, inRange);
            note(id,
                 fmt::format("{}\"{}\" is outside its range and was brought into it",
                             part.name.empty() ? "" : part.name + " of ", id),
                 fmt::format("{} to {}", Json(parameter.min).dump(), Json(parameter.max).dump()),
                 part.pointer);
        }
        return roundedToFloat(inRange);
    }

    /// Parks a choice that is not known, since it may be one of a later version; any other misfit
    /// is an error. Returns the default.
    Value refused(const Parameter& parameter, const std::string& id, const Json& json,
                  const ValueError& why) {
        if (infoOf(parameter.type).isChoice && json.is_string()) {
            note(id,
                 fmt::format("\"{}\" is no choice of \"{}\"; the default is used",
                             json.get<std::string>(), id),
                 why.expected);
            parked_[id] = json;
        } else {
            reader_.addError(id, why);
        }
        return roundedToFloat(parameter.defaultValue);
    }

    JsonReader& reader_;
    BlockValues& values_;
    Errors& notes_;
    Json& parked_;
};

/// Returns what is wrong with levels of accuracy choices in a block, which stand elsewhere or
/// nowhere; nothing where it has none.
std::optional<Error> misplacedAccuracy(const JsonReader& block, std::string_view kind) {
    constexpr const char* key = "accuracy";
    if (!block.unknown().contains(key)) {
        return std::nullopt;
    }
    const bool isChosen = hasChosenLevels(kind);
    const BlockKind* known = findKind(kind);
    return block.document().error(
        block.pointer(key),
        isChosen ? "levels are not read from here"
                 : fmt::format("no level of a {} is chosen: its exact way is drawn",
                               known == nullptr ? kind : known->singular),
        isChosen ? "\"accuracy\" of the preset itself" : "no \"accuracy\" here");
}

std::vector<std::string> idsOf(const std::vector<const Block*>& blocks) {
    std::vector<std::string> ids;
    for (const Block* block : blocks) {
        ids.push_back(block->id);
    }
    return ids;
}

} // namespace

BlockValues BlockReader::read(JsonReader& block, JsonReader& parameters, std::string_view kind,
                              nlohmann::json& parked) const {
    BlockValues values;
    block.read("id", values.id);
    block.read("version", values.version);
    const Json* id = block.find("id");
    if (block.isObject() && id == nullptr) {
        block.addError("id", "the key \"id\" is missing", "the id of a block");
    } else if (id != nullptr && id->is_string() && id->get_ref<const std::string&>().empty()) {
        block.addError("id", "the id is empty", oneOf({}, idsOf(catalog.ofKind(kind))));
    }
    if (auto misplaced = misplacedAccuracy(block, kind)) {
        notes.push_back(std::move(*misplaced));
    }
    ValuesReader reader(parameters, values, notes, parked);
    const Block* known = catalog.find(kind, values.id);
    if (known != nullptr) {
        values.id = known->id;
        reader.read(*known);
        if (values.version > known->version) {
            notes.push_back(
                block.document().error(block.pointer("version"),
                                       fmt::format("{} has version {} here, it may look different",
                                                   known->label, values.version),
                                       fmt::format("up to {}", known->version)));
        }
        values.version = std::max(values.version, known->version);
        return values;
    }
    if (!values.id.empty()) {
        notes.push_back(block.document().error(
            block.pointer("id"),
            fmt::format("there is no \"{}\" among the {}; its values are kept", values.id, kind),
            oneOf(values.id, idsOf(catalog.ofKind(kind)))));
    }
    reader.readAsTheyCome();
    return values;
}

BlockValues BlockReader::read(JsonReader& block, std::string_view kind) const {
    JsonReader parameters = block.child("parameters");
    Json parked = Json::object();
    block.readObject("parked", parked);
    BlockValues values = read(block, parameters, kind, parked);
    if (!parked.empty()) {
        values.unknown["parked"] = std::move(parked);
    }
    return values;
}

nlohmann::json parametersJson(const BlockValues& values) {
    Json json = values.unknown.value("parameters", Json::object());
    for (const auto& [id, value] : values.parameters) {
        json[id] = toJson(value);
    }
    return json;
}

nlohmann::json toJson(const BlockValues& values) {
    Json json = values.unknown;
    json["id"] = values.id;
    json["version"] = values.version;
    json["parameters"] = parametersJson(values);
    return json;
}

} // namespace patina
