// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/descriptor.h"

#include <utility>

#include "catalog/descriptor_words.h"
#include "catalog/spectrum.h"
#include "catalog/value_json.h"

namespace patina {
namespace {

using Json = nlohmann::json;

template <class T, class Make>
Json arrayOf(const std::vector<T>& items, Make make) {
    Json array = Json::array();
    for (const T& item : items) {
        array.push_back(make(item));
    }
    return array;
}

Json choiceJson(const EnumValue& value) {
    Json json{{"id", value.id}, {"label", value.label}, {"doc", value.doc}};
    for (const auto& [id, filled] : value.fills) {
        json["fills"][id] = fillJson(filled);
    }
    return json;
}

Json levelJson(const EnumValue& value) {
    Json json = choiceJson(value);
    json["exact"] = value.exact;
    if (!value.table.empty()) {
        json["table"] = value.table;
    }
    return json;
}

Json accuracyJson(const AccuracyChoice& choice) {
    return {{"id", choice.id},
            {"label", choice.label},
            {"doc", choice.doc},
            {"values", arrayOf(choice.values, levelJson)}};
}

Json tableJson(const BlockTable& table) {
    Json size = Json::array({table.size.x});
    if (table.size.y > 1) {
        size.push_back(table.size.y);
    }
    return {{"id", table.id}, {"size", size}, {"of", table.of}};
}

Json slotJson(const Slot& slot) {
    Json json{{"kind", slot.kind}};
    if (!slot.defaultBlock.empty()) {
        json["default"] = slot.defaultBlock;
    }
    return json;
}

Json migrationJson(const Migration& migration) {
    return {{"from", migration.from}, {"until", migration.until}};
}

Json compiledJson(const Parameter& parameter) {
    if (parameter.compiled == Compiled::WhenEqual) {
        return {{"whenEqual", parameter.equalTo}};
    }
    return parameter.compiled == Compiled::WhenZero ? Json("whenZero")
                                                    : Json(parameter.compiled == Compiled::Yes);
}

void addRange(Json& json, const Parameter& parameter) {
    json["min"] = parameter.min;
    json["max"] = parameter.max;
    json["softMin"] = parameter.softMin;
    json["softMax"] = parameter.softMax;
    json["step"] = parameter.step;
    json["scale"] = wordFor(scaleWords, parameter.scale);
    json["decimals"] = parameter.decimals;
    if (!parameter.zeroText.empty()) {
        json["zeroText"] = parameter.zeroText;
    }
}

Json parameterJson(const Parameter& parameter) {
    Json json{{"id", parameter.id},
              {"label", parameter.label},
              {"doc", parameter.doc},
              {"type", infoOf(parameter.type).word},
              {"default", toJson(parameter.defaultValue)},
              {"unit", parameter.unit},
              {"group", parameter.group},
              {"advanced", parameter.advanced},
              {"enabledWhen", parameter.enabledWhen},
              {"compiled", compiledJson(parameter)},
              {"space", wordFor(spaceWords, parameter.space)},
              {"emission", parameter.emission},
              {"transparency", parameter.transparency},
              {"highlight", wordFor(highlightWords, parameter.highlight)},
              {"role", parameter.role},
              {"texture", parameter.textureChannels},
              {"migrations", arrayOf(parameter.migrations, migrationJson)}};
    if (const auto names = componentNames(parameter); !names.empty()) {
        json["components"] = names;
    }
    if (infoOf(parameter.type).hasRange) {
        addRange(json, parameter);
    }
    if (infoOf(parameter.type).isChoice) {
        json["values"] = arrayOf(parameter.values, choiceJson);
    }
    if (const auto& physical = parameter.physical) {
        json["physical"] = {
            {"min", physical->min}, {"max", physical->max}, {"message", physical->message}};
    }
    return json;
}

Json toJson(const Hiding& hiding) {
    Json json = hiding.rate.empty() ? Json{{"from", hiding.from}, {"to", hiding.to}}
                                    : Json{{"rate", hiding.rate}, {"power", hiding.power}};
    if (!hiding.base.empty()) {
        json["base"] = hiding.base;
        json["thickness"] = hiding.thickness;
    }
    if (!hiding.size.empty()) {
        json["center"] = hiding.center;
        json["size"] = hiding.size;
    }
    if (hiding.atMost) {
        json["atMost"] = true;
    }
    return json;
}

Json neutralJson(const NeutralCase& neutral) {
    Json json = Json::object();
    for (const NeutralValue& value : neutral) {
        json[value.id] = value.word.empty() ? Json(0) : Json(value.word);
    }
    return json;
}

Json toJson(const Reach& reach) {
    Json json = Json::object();
    for (const auto& [key, id] :
         {std::pair{"from", &reach.from}, std::pair{"range", &reach.range},
          std::pair{"axis", &reach.axis}, std::pair{"angle", &reach.angle}}) {
        if (!id->empty()) {
            json[key] = *id;
        }
    }
    return json;
}

Json toJson(const PictureUse& use) {
    return {{"colors", use.isLinear ? "linear" : "display"},
            {"surfaces", use.readsSurfaces},
            {"stages", use.stages}};
}

} // namespace

nlohmann::json toJson(const Block& block) {
    Json json = {{"kind", block.kind},
                 {"id", block.id},
                 {"formerIds", block.formerIds},
                 {"version", block.version},
                 {"label", block.label},
                 {"summary", block.summary},
                 {"applications", block.applications},
                 {"source", block.source},
                 {"doc", block.doc},
                 {"parameters", arrayOf(block.parameters, parameterJson)},
                 {"accuracy", arrayOf(block.accuracy, accuracyJson)},
                 {"tables", arrayOf(block.tables, tableJson)},
                 {"slots", arrayOf(block.slots, slotJson)},
                 {"claims", block.claims},
                 {"exemptions", block.exemptions},
                 {"gates", block.gates},
                 {"lighting", wordFor(lightingWords, block.lighting)},
                 {"shadowProjection", wordFor(shadowProjectionWords, block.shadowProjection)}};
    if (block.hides) {
        json["hides"] = toJson(*block.hides);
    }
    if (!block.neutral.empty()) {
        json["neutral"] = arrayOf(block.neutral, neutralJson);
    }
    if (block.reach) {
        json["reach"] = toJson(*block.reach);
    }
    if (block.kind == kinds::pass) {
        json["picture"] = toJson(block.picture);
    }
    return json;
}

} // namespace patina
