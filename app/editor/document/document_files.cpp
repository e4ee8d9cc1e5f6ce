// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and saving.
#include <algorithm>

#include "document/commands/material_command.h"
#include "document/document.h"
#include "scene/scene_file.h"

namespace patina {

namespace {

/// Where a scene file keeps side B, and the number of the object that has it.
const char* const compareKey = "compare";
const char* const compareObjectKey = "compareObject";

Scene withSecond(Scene scene, const std::optional<Material>& second, int object) {
    if (second) {
        scene.extras[compareKey] = toJson(*second);
        scene.extras[compareObjectKey] = object;
    }
    return scene;
}

/// Takes the object of side B out of a scene that was read; the first one where none is named.
int takeSecondObject(Scene& scene) {
    const nlohmann::json named = scene.extras.value(compareObjectKey, nlohmann::json());
    scene.extras.erase(compareObjectKey);
    const auto count = static_cast<int>(scene.objects.size());
    const bool isThere = named.is_number_integer() && named >= 0 && named < count;
    return isThere ? named.get<int>() : 0;
}

/// Takes side B out of a scene that was read.
Checked<std::optional<Material>> takeSecond(Scene& scene, const std::filesystem::path& path,
                                            const Catalog& catalog, const ReadingRights& rights) {
    const auto found = scene.extras.find(compareKey);
    if (found == scene.extras.end() || !found->is_object()) {
        return std::nullopt;
    }
    const LocatedJson document{path.string(), *found, {}};
    const Checked<PresetReading> reading = materialFromJson(document, "", catalog, rights);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    scene.extras.erase(compareKey);
    return reading->material;
}

/// What saving the preset of an object does not save.
DocumentState withoutMaterial(DocumentState state, int object) {
    if (Material* material = materialAt(state, object, Side::A)) {
        *material = Material();
    }
    state.scene.camera = Camera();
    return state;
}

/// Images that will not be read from the file before its user agrees.
Errors imagesOutside(const Material& material, const std::filesystem::path& file) {
    Errors outside;
    const ReadingRights none;
    References references(file, none);
    for (const auto& [key, use] : material.textures) {
        if (!references.mayRead(use.file, OutsideFile::Kind::Image)) {
            outside.push_back({file.string(), 0, 0,
                               "is saved, but the texture \"" + use.file +
                                   "\" lies outside its folder: who opens it has to allow that",
                               "images beside the file or below it"});
        }
    }
    return outside;
}

/// Where the copy of unsaved work keeps what was not to be read.
const char* const withheldKey = "withheld";

void markOutside(Material& material, const std::string& image) {
    for (auto& [key, use] : material.textures) {
        use.outside = use.outside || use.file == image;
    }
}

/// Leaves out what a copy of unsaved work says is not to be read.
void takeWithheld(SceneReading& reading, Checked<std::optional<Material>>& second) {
    const nlohmann::json withheld = reading.scene.extras.value(withheldKey, nlohmann::json());
    reading.scene.extras.erase(withheldKey);
    for (const nlohmann::json& each : withheld) {
        if (!each.is_object() || !each.contains("file") || !each["file"].is_string() ||
            !each.contains("kind") || !each["kind"].is_number_integer()) {
            continue;
        }
        const auto file = each["file"].get<std::string>();
        if (each["kind"] != static_cast<int>(OutsideFile::Kind::Image)) {
            reading.outside.push_back({each["kind"].get<OutsideFile::Kind>(), file});
            continue;
        }
        for (Object& object : reading.scene.objects) {
            markOutside(object.material, file);
        }
        if (second && *second) {
            markOutside(**second, file);
        }
    }
}

QString titleOf(const std::filesystem::path& path) {
    return QString::fromStdString(path.filename().string());
}

} // namespace

void Document::tell(const Errors& messages) {
    for (const Error& error : messages) {
        Q_EMIT message(error);
    }
}

/// Absolute: what a path means must not depend on the folder that some later program starts in.
void Document::setFile(DocumentFile file) {
    file_ = std::move(file);
    std::error_code ignored; // it then stays as it is
    if (const auto path = std::filesystem::absolute(file_.path, ignored); !ignored) {
        file_.path = path.lexically_normal();
    }
    Q_EMIT fileChanged();
}

void Document::replaceState(DocumentState state, DocumentFile file, int object) {
    undoStack_.clear();
    interaction_ = 0;
    lastParts_.clear();
    lastSecond_.reset();
    isRecovered_ = false;
    state_ = std::move(state);
    savedState_ = state_;
    currentObject_ = state_.scene.objects.empty() ? -1 : object;
    presetObject_ = currentObject_;
    currentLight_ = state_.scene.lights.empty() ? -1 : 0;
    activeSide_ = Side::A;
    setFile(std::move(file));
    announce({DocumentChange::Scene | DocumentChange::Comparing});
}

void Document::startFrom(const Scene& scene) {
    setOutside({});
    replaceState({scene, std::nullopt}, {});
}

bool Document::openScene(const std::filesystem::path& path, const ReadingRights& rights) {
    const std::optional<Errors> notes = takeScene(path, rights);
    tell(notes.value_or(Errors()));
    return notes.has_value();
}

/// Gives what there is to say of the scene; nothing, with the errors told, when it cannot be read.
std::optional<Errors> Document::takeScene(const std::filesystem::path& path,
                                          const ReadingRights& rights) {
    Checked<SceneReading> reading = readScene(path, *catalog_, rights);
    if (!reading) {
        tell(reading.error());
        return std::nullopt;
    }
    Checked<std::optional<Material>> second = takeSecond(reading->scene, path, *catalog_, rights);
    takeWithheld(*reading, second);
    setOutside(reading->outside);
    const int object = second && *second ? takeSecondObject(reading->scene) : 0;
    replaceState({reading->scene, second.value_or(std::nullopt)},
                 {DocumentFile::Kind::Scene, path, reading->readOnly}, object);
    Errors notes = reading->notes;
    if (!second) {
        notes.insert(notes.end(), second.error().begin(), second.error().end());
    }
    return notes;
}

OutsideFiles Document::outsideOf(const std::filesystem::path& path, DocumentFile::Kind kind,
                                 const Catalog& catalog, const ReadingRights& rights) {
    if (kind == DocumentFile::Kind::Preset) {
        const auto reading = readPreset(path, catalog, rights);
        return reading ? reading->outside : OutsideFiles();
    }
    auto reading = readScene(path, catalog, rights);
    if (!reading) {
        return {};
    }
    const auto second = takeSecond(reading->scene, path, catalog, rights);
    if (second && *second) {
        for (const auto& [key, use] : (*second)->textures) {
            if (use.outside) {
                reading->outside.push_back({OutsideFile::Kind::Image, use.file});
            }
        }
    }
    return reading->outside;
}

bool Document::openTemplate(const std::filesystem::path& path) {
    const bool opened = openScene(path);
    if (opened) {
        setFile({});
    }
    return opened;
}

bool Document::recover(const std::filesystem::path& copy, const DocumentFile& origin) {
    const DocumentState before = state_;
    ReadingRights rights;
    rights.everything = true; // but for what the copy says that the user had not agreed to
    const bool opened = takeScene(copy, rights).has_value(); // its notes are on a file nobody knows
    if (opened) {
        savedState_ = before; // a preset that is saved holds no more than its material
        setFile(origin);
        isRecovered_ = true;
        undoStack_.resetClean();
    }
    return opened;
}

bool Document::openPreset(const std::filesystem::path& path, const ReadingRights& rights) {
    const Checked<PresetReading> reading = readPreset(path, *catalog_, rights);
    if (!reading) {
        tell(reading.error());
        return false;
    }
    DocumentState state = state_;
    state.lookedAt.reset();
    if (!hasSecondMaterial(state)) {
        state.second.reset();
    }
    state.picture.reset();
    if (state.scene.objects.empty()) {
        state.scene.objects.emplace_back();
    }
    const int object = std::max(currentObject_, 0);
    *materialAt(state, object, Side::A) = reading->material;
    replaceState(std::move(state), {DocumentFile::Kind::Preset, path, reading->readOnly}, object);
    tell(reading->notes);
    return true;
}

bool Document::applyPreset(const std::filesystem::path& path, Side side,
                           const ReadingRights& rights) {
    const Checked<PresetReading> reading = readPreset(path, *catalog_, rights);
    if (!reading) {
        tell(reading.error());
        return false;
    }
    if (side == Side::B && !state_.second) {
        setSecondMaterial(reading->material);
    } else {
        replaceMaterial(side, reading->material, tr("Preset %1").arg(titleOf(path)));
    }
    tell(reading->notes);
    return true;
}

Scene Document::sceneToRecover() const {
    Scene scene = sceneToSave();
    nlohmann::json withheld = nlohmann::json::array();
    for (const OutsideFile& each : outside()) {
        withheld.push_back({{"kind", static_cast<int>(each.kind)}, {"file", each.file}});
    }
    scene.extras[withheldKey] = std::move(withheld);
    return scene;
}

Scene Document::sceneToSave() const {
    Scene scene = state_.scene;
    const int object = state_.lookedAt ? state_.lookedAt->object : -1;
    if (const std::optional<Material> own = materialAside(state_, object)) {
        scene.objects[static_cast<std::size_t>(object)].material = *own;
    }
    return hasSecondMaterial(state_)
               ? withSecond(std::move(scene), state_.second, currentObject_)
               : scene;
}

bool Document::isOwnFile(const std::filesystem::path& path) const {
    std::error_code ignored; // it is no file yet
    return path == file_.path || std::filesystem::equivalent(path, file_.path, ignored);
}

bool Document::mayOverwrite(const std::filesystem::path& path) {
    if (file_.readOnly && isOwnFile(path)) {
        Q_EMIT message({path.string(), 0, 0, "the file was written by a newer version of Patina",
                        "another file name, so that nothing in it is lost"});
        return false;
    }
    return true;
}

bool Document::saveScene(const std::filesystem::path& path) {
    if (!mayOverwrite(path)) {
        return false;
    }
    Scene saved = sceneToSave();
    if (!isOwnFile(path)) { // under another name it is another scene
        saved.name = path.stem().stem().string(); // without .patina-scene.json
    }
    const Result<void> written = writeScene(path, saved);
    if (!written) {
        Q_EMIT message(written.error());
        return false;
    }
    state_.scene.name = saved.name;
    forgetShownScenes(); // they have the name too
    for (const Object& object : state_.scene.objects) {
        tell(imagesOutside(object.material, path));
    }
    savedState_ = state_;
    isRecovered_ = false;
    undoStack_.setClean();
    setFile({DocumentFile::Kind::Scene, path, false});
    return true;
}

bool Document::savePreset(const std::filesystem::path& path, Side side) {
    const Material* held = material(side);
    return held && savePreset(path, side, held->name);
}

bool Document::savePreset(const std::filesystem::path& path, Side side, const std::string& name) {
    const Material* held = material(side);
    if (!held) {
        return false;
    }
    Material saved = *held;
    saved.name = name;
    return savePreset(path, pathOf(settings::material, currentObject_, side), std::move(saved));
}

/// Nothing is called otherwise before its file is written.
bool Document::savePreset(const std::filesystem::path& path, const BlockPath& of, Material saved) {
    if (!mayOverwrite(path)) {
        return false;
    }
    Material kept = saved;
    if (const auto own = materialAside(state_, of.index); own && of.side == Side::A) {
        kept = *own;
        kept.name = saved.name;
    }
    const Result<void> written = writePreset(path, kept);
    if (!written) {
        Q_EMIT message(written.error());
        return false;
    }
    tell(imagesOutside(saved, path));
    if (file_.kind != DocumentFile::Kind::Scene) {
        if (!(*materialAt(state_, of.index, of.side) == saved)) {
            const QString label = tr("Name %1").arg(QString::fromStdString(saved.name));
            undoStack_.push(new MaterialCommand(*this, {of.index, of.side}, saved, label));
        }
        if (of.side == Side::A) {
            presetObject_ = of.index;
            setFile({DocumentFile::Kind::Preset, path, false});
        }
    }
    markPresetSaved(of.side);
    return true;
}

bool Document::outgrewPreset() const {
    return file_.kind == DocumentFile::Kind::Preset &&
           withoutMaterial(state_, presetObject_) != withoutMaterial(savedState_, presetObject_);
}

/// The document is clean only when the preset held everything that changed: lights, fog and
/// objects belong to a scene file, and closing must still ask about them.
void Document::markPresetSaved(Side side) {
    if (file_.kind == DocumentFile::Kind::Scene) {
        return; // an export
    }
    if (side == Side::B) {
        savedState_.second = state_.second;
    }
    const bool everything =
        withoutMaterial(state_, presetObject_) == withoutMaterial(savedState_, presetObject_);
    if (everything && (side == Side::A ||
                       *materialAt(state_, presetObject_, Side::A) ==
                           *materialAt(savedState_, presetObject_, Side::A))) {
        isRecovered_ = false;
        undoStack_.setClean();
    }
    if (Material* savedMaterial = materialAt(savedState_, presetObject_, Side::A);
        savedMaterial && side == Side::A) {
        *savedMaterial = *materialAt(state_, presetObject_, Side::A);
    }
}

bool Document::save() {
    switch (file_.kind) {
    case DocumentFile::Kind::Preset:
        if (const Material* held = materialAt(state_, presetObject_, Side::A)) {
            return savePreset(file_.path, pathOf(settings::material, presetObject_), *held);
        }
        return false;
    case DocumentFile::Kind::Scene:
        return saveScene(file_.path);
    default:
        return false;
    }
}

} // namespace patina
