// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/settings.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "catalog/suggestion.h"
#include "catalog/value_json.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr auto texts = std::to_array<std::pair<std::string_view, std::string_view>>({
#include "settings_texts.inc"
});

std::vector<Descriptor> readAll() {
    std::vector<Descriptor> all;
    for (const auto& [word, text] : texts) {
        if (const Result<LocatedJson> document = parseJson(text, std::string(word) + ".json")) {
            all.push_back(settingsDescriptor(*document));
        }
    }
    return all;
}

/// Reads the values of one block's settings from one object.
class SettingsReader {
  public:
    SettingsReader(JsonReader& reader, Errors& notes, const StoreSetting& store)
        : reader_(reader), notes_(notes), store_(store) {}

    void read(const Parameter& parameter) {
        const std::size_t dot = parameter.id.find('.');
        if (dot == std::string::npos) {
            readFrom(reader_, parameter.id, parameter);
            return;
        }
        const std::string key = parameter.id.substr(0, dot);
        const auto inner = inner_.try_emplace(key, reader_.child(key)).first;
        readFrom(inner->second, parameter.id.substr(dot + 1), parameter);
    }

    Json unknown() const {
        Json all = Json::object();
        for (const auto& [key, reader] : inner_) {
            if (Json unknown = reader.unknown(); !unknown.empty()) {
                all[key] = std::move(unknown);
            }
        }
        return all;
    }

  private:
    template <class T>
    static std::optional<Value> given(JsonReader& reader, const std::string& key, T value) {
        if (!reader.has(key)) {
            return std::nullopt;
        }
        reader.read(key, value);
        return Value(std::move(value));
    }

    /// Gives nothing, because no setting is a pair, a curve or a ramp.
    static std::optional<Value> given(JsonReader&, const std::string&, const glm::dvec2&) {
        return std::nullopt;
    }
    static std::optional<Value> given(JsonReader&, const std::string&, const NumberList&) {
        return std::nullopt;
    }

    /// Returns what the file has, or the default where that is of another type; nothing where the
    /// file has no value.
    std::optional<Value> valueIn(JsonReader& reader, const std::string& key,
                                 const Parameter& parameter) {
        return std::visit([&](const auto& usual) { return given(reader, key, usual); },
                          Value(roundedToFloat(parameter.defaultValue)));
    }

    void readFrom(JsonReader& reader, const std::string& key, const Parameter& parameter) {
        const std::optional<Value> value = valueIn(reader, key, parameter);
        if (!value) {
            return;
        }
        if (infoOf(parameter.type).isChoice) {
            readChoice(reader, key, parameter, std::get<std::string>(*value));
            return;
        }
        const Value inRange = roundedToFloat(conformed(parameter, *value));
        if (const Value held = store_(parameter.id, inRange); held != *value) {
            notes_.push_back(reader.document().error(
                reader.pointer(key),
                fmt::format("\"{}\" is outside its range and was brought into it", key),
                inRange == *value ? likeHeld(held) : rangeOf(parameter)));
        }
    }

    static std::string rangeOf(const Parameter& parameter) {
        return fmt::format("{} to {}", static_cast<float>(parameter.min),
                           static_cast<float>(parameter.max));
    }

    /// Gives an example where the range alone does not say what is allowed: no factor of a scale
    /// may be 0.
    static std::string likeHeld(const Value& held) {
        std::string text = writeJson(toJson(held));
        text.pop_back(); // the end of the line
        return "such as " + text;
    }

    void readChoice(JsonReader& reader, const std::string& key, const Parameter& parameter,
                    const std::string& word) {
        std::vector<std::string> ids;
        for (const EnumValue& choice : parameter.values) {
            ids.push_back(choice.id);
        }
        if (std::find(ids.begin(), ids.end(), word) != ids.end()) {
            store_(parameter.id, word);
        } else if (!word.empty()) {
            notes_.push_back(reader.document().error(
                reader.pointer(key),
                fmt::format("\"{}\" is no choice of \"{}\"; the default is used", word, key),
                oneOf(word, ids)));
        }
    }

    JsonReader& reader_;
    Errors& notes_;
    const StoreSetting& store_;
    std::map<std::string, JsonReader> inner_;
};

} // namespace

std::span<const Descriptor> settingsDescriptors() {
    static const std::vector<Descriptor> all = readAll();
    return all;
}

const Block* settingsBlock(std::string_view word) {
    const auto all = settingsDescriptors();
    const auto found = std::find_if(all.begin(), all.end(), [word](const Descriptor& each) {
        return each.block.id == word;
    });
    return found == all.end() ? nullptr : &found->block;
}

nlohmann::json readSettings(JsonReader& reader, const Block& block, Errors& notes,
                            const StoreSetting& store) {
    SettingsReader settings(reader, notes, store);
    for (const Parameter& parameter : block.parameters) {
        if (!infoOf(parameter.type).isFile) {
            settings.read(parameter);
        }
    }
    return settings.unknown();
}

void writeSettings(nlohmann::json& json, const Block& block,
                   const std::function<std::optional<Value>(std::string_view id)>& held) {
    for (const Parameter& parameter : block.parameters) {
        const std::optional<Value> value =
            infoOf(parameter.type).isFile ? std::nullopt : held(parameter.id);
        if (!value) {
            continue;
        }
        const std::size_t dot = parameter.id.find('.');
        Json& object = dot == std::string::npos ? json : json[parameter.id.substr(0, dot)];
        object[parameter.id.substr(dot == std::string::npos ? 0 : dot + 1)] =
            toJson(roundedToFloat(*value));
    }
}

} // namespace patina
