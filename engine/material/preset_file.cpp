// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/preset_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/settings.h"
#include "catalog/suggestion.h"
#include "core/atomic_file.h"
#include "material/block_values.h"
#include "material/file_header.h"
#include "material/material_settings.h"
#include "material/measured_preset.h"
#include "material/model_swap.h"
#include "material/texture_file.h"
#include "material/texture_key.h"
#include "material/texture_path.h"
#include "material/variant.h"
#include "measured/measured_reflectance.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr FileFormat presetFormat{"patina.preset", 1, "preset"};

/// Reads one preset object and collects its mistakes and notes.
class PresetReader {
  public:
    PresetReader(const LocatedJson& document, const std::string& pointer, const Catalog& catalog,
                 const ReadingRights& rights)
        : reader_(document, pointer, errors_), blocks_{catalog, reading_.notes},
          references_(document.file, rights) {}

    Checked<PresetReading> run() {
        reading_.readOnly = readHeader(reader_, presetFormat, reading_.notes) == FileAge::Newer;
        readTexts();
        readParent();
        readKept();
        readModel();
        readParts();
        readOwnSettings();
        readAccuracy();
        const TextureReading textures = readTextures(reader_, references_, reading_.notes);
        reading_.outside = references_.outside();
        material().textures = textures.uses;
        noteTextures();
        material().unknown = reader_.unknown();
        setParent(material(), parent_);
        if (!textures.unknown.empty()) {
            material().unknown["textures"] = textures.unknown;
        }
        const bool hasModel = !material().model.id.empty(); // else it could not be written again
        return hasModel ? settled(std::move(reading_), std::move(errors_))
                        : Checked<PresetReading>(tl::unexpected(std::move(errors_)));
    }

  private:
    Material& material() { return reading_.material; }

    void note(const std::string& pointer, std::string problem, std::string expected) {
        reading_.notes.push_back(
            reader_.document().error(pointer, std::move(problem), std::move(expected)));
    }

    void readTexts() {
        reader_.read("name", material().name);
        reader_.read("description", material().description);
        reader_.read("author", material().author);
        reader_.read("license", material().license);
        const Json* tags = reader_.array("tags");
        for (std::size_t i = 0; tags != nullptr && i < tags->size(); ++i) {
            if ((*tags)[i].is_string()) {
                material().tags.push_back((*tags)[i].get<std::string>());
            } else {
                reader_.addError("tags", described((*tags)[i]) + " stands among the tags", "text");
            }
        }
    }

    void readParent() {
        std::string parent;
        reader_.read("parent", parent);
        parent_ = imageFromFile(parent, references_.base());
    }

    void readKept() {
        reader_.readObject("parked", material().parked);
        reader_.readObject("extras", material().extras);
    }

    void readModel() {
        if (reader_.isObject() && !reader_.has("model")) {
            reader_.addError("model", "the key \"model\" is missing",
                             "an object with the id and version of a lighting model");
        }
        JsonReader model = reader_.child("model");
        JsonReader parameters = reader_.child("parameters");
        if (reader_.has("model")) {
            material().model = blocks_.read(model, parameters, kinds::models, material().parked);
            material().model.unknown.update(model.unknown());
            readModelFile();
        }
    }

    /// Makes the path of the model's measured file full; one that may not be read is left out.
    void readModelFile() {
        const Block* block = blocks_.catalog.find(kinds::models, material().model.id);
        const Parameter* parameter = block != nullptr ? tableParameter(*block) : nullptr;
        if (parameter == nullptr) {
            return;
        }
        Value& value = material().model.parameters[parameter->id];
        auto* file = std::get_if<std::string>(&value);
        if (file == nullptr || file->empty()) {
            return;
        }
        if (references_.mayRead(*file, OutsideFile::Kind::Image)) {
            *file = imageFromFile(*file, references_.base());
        } else {
            note(reader_.pointer("parameters") + '/' + escapedToken(parameter->id),
                 fmt::format(
                     "the measured file \"{}\" is not in the preset's folder and is not used",
                     *file),
                 "a relative path with forward slashes into that folder");
            material().parked[parameter->id] = *file;
            file->clear();
        }
    }

    void readParts() {
        for (const std::string_view kind : partKinds(BlockOwner::Material)) {
            const std::string key(kind);
            const Json* part = reader_.find(key);
            if (part != nullptr && !part->is_null()) {
                JsonReader block = reader_.child(key);
                BlockValues& values = material().parts[key];
                values = blocks_.read(block, kind);
                values.unknown.update(block.unknown());
                notePlace(key);
            }
        }
    }

    /// Notes a part that does nothing with this model; it is kept for the next one.
    void notePlace(const std::string& kind) {
        const Block* model = blocks_.catalog.find(kinds::models, material().model.id);
        if (model != nullptr && !hasPlaceFor(*model, kind)) {
            note(reader_.pointer(kind),
                 fmt::format("the model \"{}\" has no place for this", model->id),
                 fmt::format("a model with a {} slot", kind));
        }
    }

    void readOwnSettings() {
        const auto store = [this](std::string_view id, const Value& value) {
            storeSetting(material(), id, value);
            return *settingOf(material(), id);
        };
        readSettings(reader_, *settingsBlock(settings::material), reading_.notes, store);
    }

    void readAccuracy() {
        JsonReader levels = reader_.child("accuracy");
        const Json all = levels.unknown();
        for (const auto& [choice, level] : all.items()) {
            levels.read(choice, material().accuracy[choice]);
        }
        noteChoices(all);
        completeLevels(kinds::models, material().model.id);
        for (const auto& [kind, values] : material().parts) {
            completeLevels(kind, values.id);
        }
    }

    /// Notes a choice that no block of the catalogue has, since it may be misspelt, unless a block
    /// of the material is missing that may have it. A choice of another block is kept silently.
    void noteChoices(const Json& levels) {
        std::vector<std::string> known;
        bool isAllThere = addChoices(kinds::models, material().model.id, known);
        for (const auto& [kind, values] : material().parts) {
            isAllThere = addChoices(kind, values.id, known) && isAllThere;
        }
        for (const auto& item : levels.items()) {
            const std::string& choice = item.key();
            if (isAllThere && !isChoiceOfAny(choice)) {
                note(reader_.pointer("accuracy") + '/' + escapedToken(choice),
                     fmt::format("\"{}\" is no accuracy choice", choice),
                     known.empty() ? "nothing: this material has no such choice"
                                   : oneOf(choice, known));
            }
        }
    }

    /// Adds the ids of a block's choices; false where the catalogue does not know the block.
    bool addChoices(std::string_view kind, const std::string& id,
                    std::vector<std::string>& known) const {
        const Block* block = blocks_.catalog.find(kind, id);
        if (block == nullptr) {
            return false;
        }
        for (const AccuracyChoice& choice : block->accuracy) {
            known.push_back(choice.id);
        }
        return true;
    }

    bool isChoiceOfAny(const std::string& choice) const {
        return std::ranges::any_of(blocks_.catalog.blocks, [&choice](const Block& block) {
            return block.accuracyChoice(choice) != nullptr;
        });
    }

    void completeLevels(std::string_view kind, const std::string& id) {
        const Block* block = blocks_.catalog.find(kind, id);
        if (block == nullptr) {
            return;
        }
        for (const AccuracyChoice& choice : block->accuracy) {
            std::string& level = material().accuracy[choice.id];
            std::vector<std::string> levels;
            for (const EnumValue& value : choice.values) {
                levels.push_back(value.id);
            }
            if (std::find(levels.begin(), levels.end(), level) != levels.end()) {
                continue;
            }
            if (!level.empty()) {
                material().parked[choice.id] = level;
                note(reader_.pointer("accuracy") + '/' + escapedToken(choice.id),
                     fmt::format("\"{}\" is no level of \"{}\"; the exact one is used", level,
                                 choice.id),
                     oneOf(level, levels));
            }
            level = levels.front();
        }
    }

    void noteTextures() {
        for (const auto& [key, use] : material().textures) {
            if (const auto why = whyNoImage(key, material(), blocks_.catalog)) {
                note(reader_.pointer("textures") + '/' + escapedToken(key), why->problem,
                     why->expected);
            }
        }
    }

    Errors errors_;
    PresetReading reading_;
    JsonReader reader_;
    BlockReader blocks_;
    References references_;
    std::string parent_;
};

/// Returns the model object without its values, which stand beside it in the file.
Json modelJson(const BlockValues& model) {
    Json json = model.unknown;
    json.erase("parameters");
    json["id"] = model.id;
    json["version"] = model.version;
    return json;
}

/// Returns the model's values; the path of a measured file is relative to the folder.
Json modelParametersJson(const BlockValues& model, const std::filesystem::path& folder) {
    Json json = parametersJson(model);
    for (const auto& [id, value] : model.parameters) {
        if (const auto* text = std::get_if<std::string>(&value); text && isMeasuredFile(*text)) {
            json[id] = imageForFile(*text, folder);
        }
    }
    return json;
}

} // namespace

Checked<PresetReading> materialFromJson(const LocatedJson& document, const std::string& pointer,
                                        const Catalog& catalog, const ReadingRights& rights) {
    return PresetReader(document, pointer, catalog, rights).run();
}

nlohmann::json toJson(const Material& material, const std::filesystem::path& folder) {
    Json json = material.unknown;
    if (const std::string parent = parentOf(material); !parent.empty()) {
        json["parent"] = imageForFile(parent, folder);
    }
    json["format"] = presetFormat.name;
    json["version"] = presetFormat.version;
    json["name"] = material.name;
    json["description"] = material.description;
    json["author"] = material.author;
    json["license"] = material.license;
    json["tags"] = material.tags;
    json["model"] = modelJson(material.model);
    json["parameters"] = modelParametersJson(material.model, folder);
    json[std::string(kinds::fresnel)] = Json(); // a preset always says whether it has one
    for (const auto& [kind, values] : material.parts) {
        json[kind] = toJson(values);
    }
    writeSettings(json, *settingsBlock(settings::material),
                  [&material](std::string_view id) { return settingOf(material, id); });
    json["accuracy"] = material.accuracy;
    json["textures"] = material.unknown.value("textures", Json::object());
    for (const auto& [key, use] : material.textures) {
        json["textures"][key] = toJson(use, key, folder);
    }
    json["parked"] = material.parked;
    json["extras"] = material.extras;
    return json;
}

Checked<PresetReading> readPreset(const std::filesystem::path& path, const Catalog& catalog,
                                  const ReadingRights& rights) {
    if (isMeasuredFile(path)) {
        return readMeasuredPreset(path, catalog);
    }
    const Result<LocatedJson> document = readJson(path);
    if (!document) {
        return tl::unexpected(Errors{document.error()});
    }
    return document->value.is_object() && document->value.contains("parent")
               ? readVariant(*document, catalog, rights)
               : materialFromJson(*document, "", catalog, rights);
}

Json presetJson(const Material& material, const std::filesystem::path& file,
                const Catalog& catalog) {
    return parentOf(material).empty() ? toJson(material, referenceFolder(file))
                                      : variantJson(material, file, catalog);
}

Result<void> writePreset(const std::filesystem::path& path, const Material& material,
                         const Catalog& catalog) {
    return writeFileAtomically(path, writeJson(presetJson(material, path, catalog)));
}

} // namespace patina
