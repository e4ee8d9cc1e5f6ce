// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/texture_file.h"

#include <fmt/format.h>

#include "catalog/value_json.h"
#include "material/texture_path.h"

namespace patina {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> everyChannel{"rgb", "r", "g", "b", "a"};

/// Reads one image of a preset and its settings.
class TextureReader {
  public:
    TextureReader(JsonReader reader, std::string_view key, Errors& notes)
        : reader_(std::move(reader)), notes_(notes), use_(textureUse(key, {})),
          settings_(textureSettings(textureRole(key), everyChannel)) {}

    TextureUse run(References& references) {
        readFile(references);
        reader_.read("enabled", use_.enabled);
        Json kept = Json::object();
        for (const Parameter& setting : settings_.parameters) {
            readSetting(setting, kept);
        }
        use_.unknown = reader_.unknown();
        use_.unknown.update(kept);
        return use_;
    }

  private:
    void note(std::string_view key, std::string problem, std::string expected) {
        notes_.push_back(reader_.document().error(reader_.pointer(key), std::move(problem),
                                                  std::move(expected)));
    }

    void readFile(References& references) {
        reader_.read("file", use_.file);
        use_.outside =
            !isVertexColors(use_.file) && !references.mayRead(use_.file, OutsideFile::Kind::Image);
        if (use_.outside) {
            note("file",
                 fmt::format("the texture \"{}\" is not in the preset's folder and is not used",
                             use_.file),
                 "a relative path with forward slashes into that folder");
        }
        use_.file = imageFromFile(use_.file, references.base());
    }

    /// Reads one setting. A choice that is not known may be one of a later version: it goes to
    /// `kept`, and the default is used.
    void readSetting(const Parameter& setting, Json& kept) {
        const Json* json = reader_.find(setting.id);
        if (json == nullptr) {
            return;
        }
        const ValueReading value = valueFromJson(setting, *json);
        if (!value && infoOf(setting.type).isChoice && json->is_string()) {
            note(setting.id,
                 fmt::format("\"{}\" is no choice of \"{}\"; the usual one is used",
                             json->get<std::string>(), setting.id),
                 value.error().expected);
            kept[setting.id] = *json;
        } else if (!value) {
            reader_.addError(setting.id, value.error());
        } else {
            store(setting, *value);
        }
    }

    void store(const Parameter& setting, const Value& value) {
        const Value inRange = conformed(setting, value);
        if (inRange != value) {
            note(setting.id,
                 fmt::format("\"{}\" is outside its range and was brought into it", setting.id),
                 fmt::format("{} to {}", Json(setting.min).dump(), Json(setting.max).dump()));
        }
        storeTextureSetting(use_, setting.id, inRange);
    }

    JsonReader reader_;
    Errors& notes_;
    TextureUse use_;
    Block settings_;
};

bool namesFile(const Json& texture) {
    const auto file = texture.is_object() ? texture.find("file") : texture.end();
    return texture.is_object() && file != texture.end() && file->is_string();
}

} // namespace

TextureReading readTextures(JsonReader& preset, References& references, Errors& notes) {
    TextureReading reading;
    JsonReader textures = preset.child("textures");
    const Json all = textures.unknown();
    for (const auto& [key, texture] : all.items()) {
        if (namesFile(texture)) {
            reading.uses[key] = TextureReader(textures.child(key), key, notes).run(references);
            continue;
        }
        notes.push_back(textures.document().error(
            textures.pointer(key), "the texture names no file", "an object with \"file\""));
        reading.unknown[key] = texture;
    }
    return reading;
}

nlohmann::json toJson(const TextureUse& use, std::string_view key,
                      const std::filesystem::path& folder) {
    Json json = use.unknown;
    json["file"] = imageForFile(use.file, folder);
    if (!use.enabled) {
        json["enabled"] = false;
    }
    for (const Parameter& setting : textureSettings(textureRole(key), everyChannel).parameters) {
        const Value value = textureSetting(use, setting.id);
        if (!json.contains(setting.id) || value != setting.defaultValue) {
            json[setting.id] = toJson(value);
        }
    }
    return json;
}

} // namespace patina
