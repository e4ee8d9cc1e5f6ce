// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/descriptor.h"

#include "catalog/descriptor_checks.h"
#include "catalog/descriptor_words.h"
#include "catalog/spectrum.h"
#include "catalog/value_json.h"

namespace patina {
namespace {

/// Limits the size to twenty times the longest that ships, because checks compare ids with one
/// another.
constexpr JsonLimits descriptorLimits{.bytes = std::size_t(256) << 10};

using Json = nlohmann::json;

/// Reads members of an object; one that is missing or of the wrong type (which the schema reports)
/// leaves the default.
class Fields {
  public:
    explicit Fields(const Json& object) : object_(object) {}

    const Json* find(const char* key) const {
        const auto found = object_.is_object() ? object_.find(key) : object_.end();
        return found == object_.end() ? nullptr : &*found;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        if (object_.is_object()) {
            for (const auto& [name, value] : object_.items()) {
                all.push_back(name);
            }
        }
        return all;
    }
    bool has(const char* key) const { return find(key) != nullptr; }

    void read(const char* key, std::string& into) const {
        if (const Json* json = find(key); json != nullptr && json->is_string()) {
            into = json->get<std::string>();
        }
    }
    void read(const char* key, bool& into) const {
        if (const Json* json = find(key); json != nullptr && json->is_boolean()) {
            into = json->get<bool>();
        }
    }
    void read(const char* key, double& into) const {
        if (const Json* json = find(key); json != nullptr && json->is_number()) {
            into = json->get<double>();
        }
    }
    void read(const char* key, int& into) const {
        if (const Json* json = find(key); json != nullptr && json->is_number_integer()) {
            into = json->get<int>();
        }
    }
    void read(const char* key, std::vector<std::string>& into) const {
        if (const Json* json = find(key); json != nullptr && json->is_array()) {
            into = strings(*json);
        }
    }
    template <class T, std::size_t N>
    void read(const char* key, const Words<T, N>& words, T& into) const {
        std::string word;
        read(key, word);
        into = meaningOf(words, word).value_or(into);
    }
    /// Appends what `make` returns for each element of an array member.
    template <class T, class Make>
    void readEach(const char* key, std::vector<T>& into, Make make) const {
        const Json* json = find(key);
        if (json == nullptr || !json->is_array()) {
            return;
        }
        for (const Json& element : *json) {
            into.push_back(make(Fields(element)));
        }
    }

  private:
    static std::vector<std::string> strings(const Json& array) {
        std::vector<std::string> out;
        for (const Json& element : array) {
            if (element.is_string()) {
                out.push_back(element.get<std::string>());
            }
        }
        return out;
    }

    const Json& object_;
};

EnumValue enumValueFrom(const Fields& fields) {
    EnumValue value;
    fields.read("id", value.id);
    fields.read("label", value.label);
    fields.read("doc", value.doc);
    fields.read("exact", value.exact);
    fields.read("table", value.table);
    return value;
}

Slot slotFrom(const Fields& fields) {
    Slot slot;
    fields.read("kind", slot.kind);
    fields.read("default", slot.defaultBlock);
    return slot;
}

/// Reads a table, whose size is one or two numbers; the schema reports anything else.
BlockTable tableFrom(const Fields& fields) {
    BlockTable table;
    fields.read("id", table.id);
    fields.read("of", table.of);
    const Json* size = fields.find("size");
    for (std::size_t i = 0; size != nullptr && size->is_array() && i < size->size() && i < 2; ++i) {
        const Json& entries = (*size)[i];
        const bool isSize = entries.is_number_integer() && entries >= 2 && entries <= 1024;
        table.size[static_cast<int>(i)] = isSize ? entries.get<int>() : 2;
    }
    return table;
}

Migration migrationFrom(const Fields& fields) {
    Migration migration;
    fields.read("from", migration.from);
    fields.read("until", migration.until);
    return migration;
}

AccuracyChoice accuracyFrom(const Fields& fields) {
    AccuracyChoice choice;
    fields.read("id", choice.id);
    fields.read("label", choice.label);
    fields.read("doc", choice.doc);
    fields.readEach("values", choice.values, enumValueFrom);
    return choice;
}

Compiled compiledFrom(const Fields& fields) {
    const Json* json = fields.find("compiled");
    if (json == nullptr || *json == false) {
        return Compiled::No;
    }
    if (json->is_object()) {
        return Compiled::WhenEqual;
    }
    return *json == true ? Compiled::Yes : Compiled::WhenZero;
}

std::vector<std::string> channelsFrom(const Fields& fields, ParameterType type) {
    std::vector<std::string> channels;
    fields.read("texture", channels);
    bool any = false;
    fields.read("texture", any);
    if (any) {
        const bool whole = componentCount(type) == 3;
        channels = whole ? std::vector<std::string>{"rgb", "r", "g", "b", "a"}
                         : std::vector<std::string>{"r", "g", "b", "a"};
    }
    return channels;
}

std::optional<PhysicalRange> physicalFrom(const Fields& fields) {
    const Json* json = fields.find("physical");
    if (json == nullptr) {
        return std::nullopt;
    }
    PhysicalRange range;
    Fields(*json).read("min", range.min);
    Fields(*json).read("max", range.max);
    Fields(*json).read("message", range.message);
    return range;
}

/// Sets what the descriptor may leave out to the defaults of the parameter's type.
void setTypeDefaults(Parameter& parameter) {
    const ParameterTypeInfo& info = infoOf(parameter.type);
    parameter.step = info.step;
    parameter.decimals = info.decimals;
    parameter.unit = info.unit;
    parameter.components = componentNames(parameter);
}

void readRange(const Fields& fields, Parameter& parameter) {
    fields.read("min", parameter.min);
    fields.read("max", parameter.max);
    parameter.softMin = parameter.min;
    parameter.softMax = parameter.max;
    fields.read("softMin", parameter.softMin);
    fields.read("softMax", parameter.softMax);
    fields.read("step", parameter.step);
    fields.read("scale", scaleWords, parameter.scale);
    fields.read("decimals", parameter.decimals);
    fields.read("unit", parameter.unit);
    fields.read("zeroText", parameter.zeroText);
}

Parameter parameterFrom(const Fields& fields) {
    Parameter parameter;
    fields.read("id", parameter.id);
    fields.read("label", parameter.label);
    fields.read("doc", parameter.doc);
    std::string word;
    fields.read("type", word);
    parameter.type = parameterTypeOf(word).value_or(parameter.type);
    setTypeDefaults(parameter);
    readRange(fields, parameter);
    fields.read("group", parameter.group);
    fields.read("advanced", parameter.advanced);
    fields.read("enabledWhen", parameter.enabledWhen);
    fields.readEach("values", parameter.values, enumValueFrom);
    parameter.compiled =
        infoOf(parameter.type).isAlwaysCompiled ? Compiled::Yes : compiledFrom(fields);
    fields.read("components", parameter.components);
    if (parameter.compiled == Compiled::WhenEqual) {
        Fields(*fields.find("compiled")).read("whenEqual", parameter.equalTo);
    }
    fields.read("space", spaceWords, parameter.space);
    fields.read("emission", parameter.emission);
    fields.read("transparency", parameter.transparency);
    fields.read("highlight", highlightWords, parameter.highlight);
    fields.read("role", parameter.role);
    parameter.textureChannels = channelsFrom(fields, parameter.type);
    parameter.physical = physicalFrom(fields);
    fields.readEach("migrations", parameter.migrations, migrationFrom);
    if (const Json* json = fields.find("default")) {
        parameter.defaultValue = valueFromJson(parameter, *json).value_or(Value(0.0));
    }
    return parameter;
}

std::map<std::string, std::string> exemptionsFrom(const Fields& fields) {
    std::map<std::string, std::string> exemptions;
    const Json* json = fields.find("exemptions");
    if (json != nullptr && json->is_object()) {
        for (const auto& [claim, reason] : json->items()) {
            Fields(*json).read(claim.c_str(), exemptions[claim]);
        }
    }
    return exemptions;
}

std::optional<Hiding> hidingFrom(const Fields& fields) {
    const Json* json = fields.find("hides");
    if (json == nullptr) {
        return std::nullopt;
    }
    Hiding hiding;
    Fields(*json).read("rate", hiding.rate);
    Fields(*json).read("power", hiding.power);
    Fields(*json).read("from", hiding.from);
    Fields(*json).read("to", hiding.to);
    Fields(*json).read("base", hiding.base);
    Fields(*json).read("thickness", hiding.thickness);
    Fields(*json).read("center", hiding.center);
    Fields(*json).read("size", hiding.size);
    Fields(*json).read("atMost", hiding.atMost);
    return hiding;
}

/// Reads a condition. A number leaves the word empty; neutralMistakes() checks that it is 0.
NeutralCase neutralFrom(const Fields& fields) {
    NeutralCase neutral;
    for (const std::string& id : fields.names()) {
        neutral.push_back({id, {}});
        fields.read(id.c_str(), neutral.back().word);
    }
    return neutral;
}

std::optional<Reach> reachFrom(const Fields& fields) {
    const Json* json = fields.find("reach");
    if (json == nullptr) {
        return std::nullopt;
    }
    Reach reach;
    Fields(*json).read("from", reach.from);
    Fields(*json).read("range", reach.range);
    Fields(*json).read("axis", reach.axis);
    Fields(*json).read("angle", reach.angle);
    return reach;
}

PictureUse pictureUseFrom(const Fields& fields) {
    PictureUse use;
    if (const Json* json = fields.find("picture")) {
        std::string colors;
        Fields(*json).read("colors", colors);
        use.isLinear = colors == "linear";
        Fields(*json).read("surfaces", use.readsSurfaces);
        Fields(*json).read("stages", use.stages);
    }
    return use;
}

/// Returns what a choice sets, as values of the parameters it names; the checker reports mistakes.
Values fillsFrom(const Block& block, const Json& choice) {
    Values fills;
    const Json* json = Fields(choice).find("fills");
    if (json == nullptr || !json->is_object()) {
        return fills;
    }
    for (const auto& [id, value] : json->items()) {
        const Parameter* filled = block.parameter(id);
        if (const auto read =
                filled == nullptr ? ValueReading(failure("")) : fillFromJson(*filled, value)) {
            fills.emplace(id, *read);
        }
    }
    return fills;
}

/// Reads the fills of all choices. It needs all parameters: a choice may set one that stands after
/// it.
void readFills(Block& block, const Json& document) {
    for (std::size_t i = 0; i < block.parameters.size(); ++i) {
        std::vector<EnumValue>& values = block.parameters[i].values;
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k].fills = fillsFrom(block, document["parameters"][i]["values"][k]);
        }
    }
}

Block blockFrom(const std::filesystem::path& path, const Fields& fields) {
    Block block;
    block.kind = path.parent_path().filename().string();
    block.descriptorFile = path;
    block.shaderFile = std::filesystem::path(path).replace_extension(".glsl");
    fields.read("id", block.id);
    fields.read("formerIds", block.formerIds);
    fields.read("version", block.version);
    fields.read("label", block.label);
    fields.read("summary", block.summary);
    fields.read("applications", block.applications);
    fields.read("source", block.source);
    fields.read("doc", block.doc);
    fields.readEach("parameters", block.parameters, parameterFrom);
    fields.readEach("accuracy", block.accuracy, accuracyFrom);
    fields.readEach("tables", block.tables, tableFrom);
    fields.readEach("slots", block.slots, slotFrom);
    fields.read("claims", block.claims);
    block.exemptions = exemptionsFrom(fields);
    block.gates = {"light", "view"};
    fields.read("gates", block.gates);
    fields.read("lighting", lightingWords, block.lighting);
    fields.read("shadowProjection", shadowProjectionWords, block.shadowProjection);
    block.hides = hidingFrom(fields);
    block.reach = reachFrom(fields);
    block.picture = pictureUseFrom(fields);
    fields.readEach("neutral", block.neutral, neutralFrom);
    return block;
}

} // namespace

Descriptor settingsDescriptor(const LocatedJson& document) {
    Block block = blockFrom(document.file, Fields(document.value));
    block.kind = "settings";
    block.shaderFile.clear();
    readFills(block, document.value);
    return {std::move(block), document};
}

Checked<Descriptor> readDescriptor(const std::filesystem::path& path, const JsonSchema& schema) {
    Result<LocatedJson> document = readJson(path, descriptorLimits);
    if (!document) {
        return tl::unexpected(Errors{document.error()});
    }
    Errors errors = schema.check(*document);
    Block block = blockFrom(path, Fields(document->value));
    readFills(block, document->value);
    Descriptor descriptor{std::move(block), std::move(*document)};
    const Errors more = descriptorMistakes(descriptor);
    errors.insert(errors.end(), more.begin(), more.end());
    if (!errors.empty()) {
        sortByPlace(errors);
        return tl::unexpected(std::move(errors));
    }
    return descriptor;
}

} // namespace patina
