// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "catalog/json_reader.h"
#include "catalog/settings.h"
#include "catalog/suggestion.h"
#include "material/block_values.h"
#include "scene/environment.h"
#include "scene/mesh_path.h"
#include "scene/picture_accuracy_file.h"
#include "scene/primitives.h"
#include "scene/scene_format.h"
#include "scene/scene_limits.h"
#include "scene/scene_settings.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr int maxBookmarks = 9; ///< allows one for each digit but 0

/// Returns "khronos-neutral" for "khronosNeutral".
std::string kebabCase(std::string_view word) {
    std::string text;
    for (const char c : word) {
        const bool isCapital = c >= 'A' && c <= 'Z';
        text += isCapital ? "-" : "";
        text += isCapital ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return text;
}

constexpr const char* relativePath = "a relative path with forward slashes into that folder";

/// Reads one scene file and collects its mistakes.
class SceneReader {
  public:
    SceneReader(const LocatedJson& document, const Catalog& catalog, const ReadingRights& rights)
        : document_(document), rights_(rights), references_(document.file, rights),
          reader_(document, "", errors_), blocks_{catalog, reading_.notes} {}

    Checked<SceneReading> run() {
        reading_.readOnly = readHeader(reader_, sceneFormat, reading_.notes) == FileAge::Newer;
        reader_.read("name", scene().name);
        readObjects();
        readLights();
        scene().parts = partsOf(reader_, BlockOwner::Scene);
        readPasses();
        readFormerTone();
        readOwnSettings();
        reader_.readObject("extras", scene().extras);
        keepUnknown();
        readPictureAccuracy(reader_, scene(), reading_.notes);
        reading_.outside = references_.outside();
        return settled(std::move(reading_), std::move(errors_));
    }

  private:
    Scene& scene() { return reading_.scene; }

    void note(const std::string& pointer, std::string problem, std::string expected = {}) {
        reading_.notes.push_back(document_.error(pointer, std::move(problem), std::move(expected)));
    }

    /// Reads the settings that settingsBlock() has for a word; returns the keys that are not known.
    template <class Owner>
    Json readSettingsOf(Owner& owner, std::string_view word, JsonReader& reader) {
        const auto store = [&owner](std::string_view id, const Value& value) {
            storeSetting(owner, id, value);
            return *settingOf(owner, id);
        };
        return readSettings(reader, *settingsBlock(word), reading_.notes, store);
    }

    void readObjects() {
        const Json* objects = reader_.array("objects");
        for (std::size_t i = 0; objects != nullptr && i < objects->size(); ++i) {
            JsonReader object(document_, fmt::format("/objects/{}", i), errors_);
            scene().objects.push_back(objectFrom(object));
        }
    }

    Object objectFrom(JsonReader& reader) {
        Object object;
        reader.read("name", object.name);
        reader.read("group", object.group);
        reader.read("part", object.part);
        readSettingsOf(object, settings::object, reader);
        readMesh(reader, object);
        object.material = materialOf(reader);
        object.unknown.update(reader.unknown());
        return object;
    }

    void readMesh(JsonReader& reader, Object& object) {
        std::string mesh = object.mesh;
        reader.read("mesh", mesh);
        if (const auto builtin = builtinName(mesh)) {
            checkBuiltin(reader, std::string(*builtin));
        } else if (!references_.mayRead(mesh, OutsideFile::Kind::Mesh)) {
            note(reader.pointer("mesh"),
                 fmt::format("the mesh \"{}\" is not in the scene's folder and is not read", mesh),
                 relativePath);
        }
        object.mesh = meshFromFile(mesh, references_.base());
    }

    void checkBuiltin(const JsonReader& reader, const std::string& name) {
        const std::vector<std::string> names = primitiveNames();
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            note(reader.pointer("mesh"), fmt::format("there is no built-in mesh \"{}\"", name),
                 oneOf(name, names));
        }
    }

    Material materialOf(JsonReader& object) {
        const Json* preset = object.find("preset");
        if (preset == nullptr) {
            note(object.pointer(), "the object has no preset; a default is used",
                 "\"preset\": an object, or the path of a preset file");
            return fallback();
        }
        if (preset->is_string()) {
            return materialFromFile(object, preset->get<std::string>());
        }
        Checked<PresetReading> reading =
            materialFromJson(document_, object.pointer("preset"), blocks_.catalog, rights_);
        return reading ? taken(*reading) : damaged(reading.error(), *preset);
    }

    Material materialFromFile(JsonReader& object, const std::string& path) {
        const auto known = presets_.find(path);
        return known != presets_.end()
                   ? known->second
                   : presets_.emplace(path, presetFrom(path, object.pointer("preset")))
                         .first->second;
    }

    Material presetFrom(const std::string& path, const std::string& place) {
        if (!references_.mayRead(path, OutsideFile::Kind::Preset)) {
            return damaged({document_.error(
                               place,
                               fmt::format("the preset \"{}\" is not in the scene's folder and is "
                                           "not read",
                                           path),
                               relativePath)},
                           path);
        }
        Checked<PresetReading> reading =
            readPreset(references_.base() / path, blocks_.catalog, references_.rightsOf(path));
        return reading ? taken(*reading) : damaged(atPlace(reading.error(), place), path);
    }

    /// Moves errors without a line, as that a file is missing, to the place that names the file.
    Errors atPlace(Errors errors, const std::string& pointer) const {
        for (Error& error : errors) {
            const auto problem =
                fmt::format("the preset \"{}\" is not used: {}", error.file, error.problem);
            error = error.line > 0 ? error : document_.error(pointer, problem, error.expected);
        }
        return errors;
    }

    Material taken(PresetReading& reading) {
        references_.add(reading.outside);
        reading_.notes.insert(reading_.notes.end(), reading.notes.begin(), reading.notes.end());
        return std::move(reading.material);
    }

    /// Replaces a preset that cannot be read with a default and keeps its JSON, so that the rest of
    /// the scene opens.
    Material damaged(const Errors& why, const Json& preset) {
        reading_.notes.insert(reading_.notes.end(), why.begin(), why.end());
        Material material = fallback();
        material.extras["damagedPreset"] = preset;
        return material;
    }

    Material fallback() const {
        const std::vector<const Block*> models = blocks_.catalog.ofKind(kinds::models);
        return models.empty() ? Material{} : defaultMaterial(*models.front());
    }

    void readLights() {
        const Json* lights = reader_.array("lights");
        for (std::size_t i = 0; lights != nullptr && i < lights->size(); ++i) {
            JsonReader reader(document_, fmt::format("/lights/{}", i), errors_);
            Light light;
            reader.read("name", light.name);
            reader.read("mutedBySolo", light.isMutedBySolo);
            readSettingsOf(light, settings::light, reader);
            light.parts = partsOf(reader, BlockOwner::Light);
            light.block = blocks_.read(reader, kinds::lights);
            light.block.unknown.update(reader.unknown());
            scene().lights.push_back(std::move(light));
        }
    }

    void readPasses() {
        const Json* passes = reader_.array("passes");
        for (std::size_t i = 0; passes != nullptr && i < passes->size(); ++i) {
            JsonReader reader(document_, fmt::format("/passes/{}", i), errors_);
            scene().passes.push_back(partFrom(std::move(reader), kinds::pass));
        }
    }

    BlockParts partsOf(JsonReader& reader, BlockOwner owner) {
        BlockParts parts;
        for (const std::string_view kind : partKinds(owner)) {
            const std::string_view key = findKind(kind)->singular;
            const Json* json = reader.find(key);
            if (json != nullptr && !json->is_null() && !isFormer(kind, *json)) {
                patina::setPart(parts, kind, partFrom(reader.child(key), kind));
            }
        }
        return parts;
    }

    /// Tells whether this is the object without an id that scenes had before there were
    /// environments, and keeps it.
    bool isFormer(std::string_view kind, const Json& json) {
        const bool is = kind == kinds::environment && json.is_object() && !json.contains("id");
        formerEnvironment_ = is ? json : formerEnvironment_;
        return is;
    }

    /// Reads the word that scenes had before tone curves were blocks: "khronosNeutral", which is
    /// also used where there is no word.
    void readFormerTone() {
        std::string word = "khronosNeutral";
        reader_.read("toneMapping", word);
        const std::string_view none = findKind(kinds::tone)->noneWord;
        if (reader_.find(findKind(kinds::tone)->singular) != nullptr || word == none) {
            return;
        }
        const std::string id = kebabCase(word);
        const Block* block = blocks_.catalog.find(kinds::tone, id);
        if (block != nullptr) {
            scene().setPart(kinds::tone, defaultBlockValues(*block));
            return;
        }
        if (reader_.find("toneMapping") == nullptr) {
            return;
        }
        std::vector<std::string> words{std::string(none)};
        for (const Block* each : blocks_.catalog.ofKind(kinds::tone)) {
            words.push_back(each->id);
        }
        note(reader_.pointer("toneMapping"), fmt::format("there is no tone curve \"{}\"", word),
             oneOf(id, words));
    }

    BlockValues partFrom(JsonReader reader, std::string_view kind) {
        BlockValues values = blocks_.read(reader, kind);
        values.unknown.update(reader.unknown());
        readPictureFile(reader, kind, values);
        return values;
    }

    /// Makes the path of a picture absolute, which starts at the scene's folder.
    void readPictureFile(const JsonReader& reader, std::string_view kind, BlockValues& values) {
        const Block* block = blocks_.catalog.find(kind, values.id);
        const Parameter* parameter = block == nullptr ? nullptr : pictureParameter(*block);
        const std::string file(parameter == nullptr ? "" : pictureFile(values, *block));
        if (file.empty()) {
            return;
        }
        if (!references_.mayRead(file, OutsideFile::Kind::Picture)) {
            note(fmt::format("{}/{}", reader.pointer("parameters"), escapedToken(parameter->id)),
                 fmt::format("the picture \"{}\" is not in the scene's folder and is not read",
                             file),
                 relativePath);
        }
        values.parameters[parameter->id] = meshFromFile(file, references_.base());
    }

    void readOwnSettings() {
        unknownInside_ = readSettingsOf(scene(), settings::scene, reader_);
        JsonReader camera = reader_.child(settings::camera);
        readSettingsOf(scene().camera, settings::camera, camera);
        if (Json unknown = camera.unknown(); !unknown.empty()) {
            unknownInside_[std::string(settings::camera)] = std::move(unknown);
        }
        readBookmarks();
    }

    void readBookmarks() {
        JsonReader all = reader_.child("bookmarks");
        for (int digit = 1; digit <= maxBookmarks; ++digit) {
            if (all.has(std::to_string(digit))) {
                JsonReader camera = all.child(std::to_string(digit));
                readSettingsOf(scene().bookmarks[digit], settings::camera, camera);
            }
        }
        if (Json unknown = all.unknown(); !unknown.empty()) {
            unknownInside_["bookmarks"] = std::move(unknown);
        }
    }

    void keepUnknown() {
        scene().unknown = reader_.unknown();
        scene().unknown.update(unknownInside_);
        if (!formerEnvironment_.empty()) {
            scene().unknown[std::string(kinds::environment)] = std::move(formerEnvironment_);
        }
    }

    const LocatedJson& document_;
    const ReadingRights& rights_;
    References references_;
    Errors errors_;
    SceneReading reading_;
    std::map<std::string, Material> presets_; ///< are by path, so that each file is read once
    JsonReader reader_;
    BlockReader blocks_;
    Json unknownInside_ = Json::object(); ///< holds unknown keys inside objects
    Json formerEnvironment_;
};

} // namespace

Checked<SceneReading> readScene(const std::filesystem::path& path, const Catalog& catalog,
                                const ReadingRights& rights) {
    const Result<LocatedJson> document = readJson(path, sceneLimits);
    if (!document) {
        return tl::unexpected(Errors{document.error()});
    }
    return sceneFromJson(*document, catalog, rights);
}

Checked<SceneReading> sceneFromJson(const LocatedJson& document, const Catalog& catalog,
                                    const ReadingRights& rights) {
    return SceneReader(document, catalog, rights).run();
}

bool saysItIsAScene(const std::filesystem::path& path) {
    const Result<LocatedJson> document = readJson(path, sceneLimits);
    if (!document || !document->value.is_object()) {
        return false;
    }
    const auto format = document->value.find("format");
    return format != document->value.end() && *format == sceneFormat.name;
}

} // namespace patina
