// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document_files.h"

#include <algorithm>
#include <array>

#include "document/commands/material_command.h"
#include "document/compare_edits.h"
#include "document/snapshot_edits.h"
#include "material/parked.h"
#include "material/variant.h"
#include "measured/measured_reflectance.h"
#include "scene/scene_file.h"

namespace patina {

namespace {

/// A scene file keeps side B, and the index of the object that shows it, under these keys.
const char* const compareKey = "compare";
const char* const compareObjectKey = "compareObject";

/// A scene file keeps sides C and D under this key, as an array of materials.
const char* const compareFurtherKey = "compareFurther";

/// A scene file keeps what the sides' views have of their own under this key, as an array from A
/// on.
const char* const compareViewsKey = "compareViews";

const char* const snapshotsKey = "snapshots";

/// Holds what a scene file has of compared sides: materials that belong to no object, and what
/// their views have of their own.
struct ComparedSides {
    std::optional<Material> second;
    std::vector<Material> further;
    std::array<OwnView, sides.size()> ownViews{};
    OutsideFiles outside{}; ///< are the files that the views name and may not read

    std::vector<Material*> all() {
        std::vector<Material*> found;
        if (second) {
            found.push_back(&*second);
        }
        for (Material& material : further) {
            found.push_back(&material);
        }
        return found;
    }
};

Scene withCompared(Scene scene, const DocumentState& state, int object) {
    if (state.second) {
        scene.extras[compareKey] = toJson(*state.second);
        scene.extras[compareObjectKey] = object;
        nlohmann::json further = nlohmann::json::array();
        for (const Material& material : state.further) {
            further.push_back(toJson(material));
        }
        if (!further.empty()) {
            scene.extras[compareFurtherKey] = std::move(further);
        }
        if (!std::ranges::all_of(state.ownViews, &OwnView::isLinked)) {
            nlohmann::json views = nlohmann::json::array();
            for (const OwnView& own : state.ownViews) {
                views.push_back(toJson(own));
            }
            scene.extras[compareViewsKey] = std::move(views);
        }
    }
    return scene;
}

/// Takes the index of side B's object out of a scene that was read; returns 0 where none is named.
int takeSecondObject(Scene& scene) {
    const nlohmann::json named = scene.extras.value(compareObjectKey, nlohmann::json());
    scene.extras.erase(compareObjectKey);
    const auto count = static_cast<int>(scene.objects.size());
    const bool isThere = named.is_number_integer() && named >= 0 && named < count;
    return isThere ? named.get<int>() : 0;
}

Checked<Material> materialIn(const nlohmann::json& json, const std::filesystem::path& path,
                             const Catalog& catalog, const ReadingRights& rights) {
    const LocatedJson document{path.string(), json, {}};
    const Checked<PresetReading> reading = materialFromJson(document, "", catalog, rights);
    return reading ? Checked<Material>(reading->material) : tl::unexpected(reading.error());
}

/// Takes what the sides' views have of their own out of a scene that was read.
void takeOwnViews(ComparedSides& compared, Scene& scene, const std::filesystem::path& path,
                  const Catalog& catalog, const ReadingRights& rights) {
    const nlohmann::json views = scene.extras.value(compareViewsKey, nlohmann::json());
    if (!views.is_array() || views.size() > compared.ownViews.size()) {
        return; // the key stays, so that nothing is lost
    }
    References references(path, rights);
    for (std::size_t i = 0; i < views.size(); ++i) {
        compared.ownViews[i] = ownViewFrom({path.string(), views[i], {}}, catalog, references);
    }
    compared.outside = references.outside();
    scene.extras.erase(compareViewsKey);
}

/// Takes the sides but A, and what all have of their own, out of a scene that was read.
Checked<ComparedSides> takeCompared(Scene& scene, const std::filesystem::path& path,
                                    const Catalog& catalog, const ReadingRights& rights) {
    ComparedSides compared;
    const auto found = scene.extras.find(compareKey);
    if (found == scene.extras.end() || !found->is_object()) {
        return compared;
    }
    const Checked<Material> second = materialIn(*found, path, catalog, rights);
    if (!second) {
        return tl::unexpected(second.error());
    }
    compared.second = *second;
    scene.extras.erase(compareKey);
    takeOwnViews(compared, scene, path, catalog, rights);
    const nlohmann::json further = scene.extras.value(compareFurtherKey, nlohmann::json());
    for (const nlohmann::json& each : further) {
        const bool isRoom = compared.further.size() + indexOf(Side::C) < sides.size();
        const auto material = each.is_object() && isRoom ? materialIn(each, path, catalog, rights)
                                                         : tl::unexpected(Errors());
        if (!material) {
            return compared; // the key stays, so that nothing is lost
        }
        compared.further.push_back(*material);
    }
    scene.extras.erase(compareFurtherKey);
    return compared;
}

/// Returns the part of a state that saving the preset of an object does not save.
DocumentState withoutMaterial(DocumentState state, int object) {
    if (Material* material = materialAt(state, object, Side::A)) {
        *material = Material();
    }
    state.scene.camera = Camera();
    return state;
}

/// Returns a message for each image that is not read from the file before its user agrees.
Errors imagesOutside(const Material& material, const std::filesystem::path& file) {
    Errors outside;
    const ReadingRights none;
    References references(file, none);
    for (const auto& [key, use] : material.textures) {
        if (!isVertexColors(use.file) && !references.mayRead(use.file, OutsideFile::Kind::Image)) {
            outside.push_back({file.string(), 0, 0,
                               "is saved, but the texture \"" + use.file +
                                   "\" lies outside its folder: who opens it has to allow that",
                               "images beside the file or below it"});
        }
    }
    return outside;
}

/// The copy of unsaved work keeps under this key which files must not be read.
const char* const withheldKey = "withheld";

void markOutside(Material& material, const std::string& image) {
    for (auto& [key, use] : material.textures) {
        use.outside = use.outside || use.file == image;
    }
}

/// Marks as outside what a copy of unsaved work says must not be read.
void takeWithheld(SceneReading& reading, Checked<ComparedSides>& compared) {
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
        if (compared) {
            for (Material* material : compared->all()) {
                markOutside(*material, file);
            }
        }
    }
}

void addTo(OutsideFiles& outside, const OutsideFiles& others) {
    outside.insert(outside.end(), others.begin(), others.end());
}

QString titleOf(const std::filesystem::path& path) {
    return QString::fromStdString(path.filename().string());
}

/// Tells whether a preset file holds parked values, which must not be lost when it is written
/// again.
bool holdsParked(const std::filesystem::path& path, const Catalog& catalog) {
    const auto held = readPreset(path, catalog);
    return held && !(withoutParked(held->material, catalog) == held->material);
}

} // namespace

DocumentFiles::DocumentFiles(Document& document, QObject* parent)
    : QObject(parent), document_(document), withheld_(document) {}

void DocumentFiles::report(const Errors& messages) {
    for (const Error& error : messages) {
        Q_EMIT message(error);
    }
}

/// Makes the path absolute: what it means must not depend on the folder that a later program starts
/// in.
void DocumentFiles::setFile(DocumentFile file) {
    file_ = std::move(file);
    std::error_code ignored; // it then stays as it is
    if (const auto path = std::filesystem::absolute(file_.path, ignored); !ignored) {
        file_.path = path.lexically_normal();
    }
    Q_EMIT fileChanged();
}

/// Everything about the file is known before the document is told of the new state.
void DocumentFiles::start(DocumentState state, DocumentFile file, int object) {
    isRecovered_ = false;
    savedState_ = state;
    presetObject_ = state.scene.objects.empty() ? -1 : object;
    setFile(std::move(file));
    document_.startFrom(std::move(state), object);
}

void DocumentFiles::startFrom(const Scene& scene) {
    withheld_.set({});
    withheld_.allowLinks({});
    start({scene, std::nullopt}, {});
}

bool DocumentFiles::openScene(const std::filesystem::path& path, const ReadingRights& rights) {
    const std::optional<Errors> notes = takeScene(path, rights);
    report(notes.value_or(Errors()));
    return notes.has_value();
}

/// Returns the notes on the scene; nothing, after its errors were told, when it cannot be read.
std::optional<Errors> DocumentFiles::takeScene(const std::filesystem::path& path,
                                               const ReadingRights& rights) {
    Checked<SceneReading> reading = readScene(path, document_.catalog(), rights);
    if (!reading) {
        report(reading.error());
        return std::nullopt;
    }
    Checked<ComparedSides> compared =
        takeCompared(reading->scene, path, document_.catalog(), rights);
    takeWithheld(*reading, compared);
    if (compared) {
        addTo(reading->outside, compared->outside);
    }
    withheld_.set(reading->outside);
    withheld_.allowLinks(rights.allowed);
    const int object = compared && compared->second ? takeSecondObject(reading->scene) : 0;
    std::vector<Snapshot> snapshots =
        snapshotsFromJson(reading->scene.extras.value(snapshotsKey, nlohmann::json()), path,
                          document_.catalog(), rights);
    reading->scene.extras.erase(snapshotsKey);
    DocumentState state{reading->scene, std::nullopt};
    state.snapshots = std::move(snapshots);
    if (compared) {
        state.second = compared->second;
        state.further = compared->further;
        state.ownViews = compared->ownViews;
    }
    start(std::move(state), {DocumentFile::Kind::Scene, path, reading->readOnly}, object);
    Errors notes = reading->notes;
    if (!compared) {
        notes.insert(notes.end(), compared.error().begin(), compared.error().end());
    }
    return notes;
}

OutsideFiles DocumentFiles::outsideOf(const std::filesystem::path& path, DocumentFile::Kind kind,
                                      const Catalog& catalog, const ReadingRights& rights) {
    if (isMeasuredFile(path)) {
        return {};
    }
    if (kind == DocumentFile::Kind::Preset) {
        const auto reading = readPreset(path, catalog, rights);
        return reading ? reading->outside : parentsOutside(path, rights);
    }
    auto reading = readScene(path, catalog, rights);
    if (!reading) {
        return {};
    }
    auto compared = takeCompared(reading->scene, path, catalog, rights);
    for (const Material* material : compared ? compared->all() : std::vector<Material*>()) {
        for (const auto& [key, use] : material->textures) {
            if (use.outside) {
                reading->outside.push_back({OutsideFile::Kind::Image, use.file});
            }
        }
    }
    if (compared) {
        addTo(reading->outside, compared->outside);
    }
    return reading->outside;
}

bool DocumentFiles::openTemplate(const std::filesystem::path& path) {
    const bool opened = openScene(path);
    if (opened) {
        setFile({});
    }
    return opened;
}

bool DocumentFiles::recover(const std::filesystem::path& copy, const DocumentFile& origin) {
    const DocumentState before = document_.state();
    ReadingRights rights;
    rights.everything = true; // but for what the copy says that the user had not agreed to
    const bool opened = takeScene(copy, rights).has_value(); // its notes are on a file nobody knows
    if (opened) {
        savedState_ = before; // a preset that is saved holds no more than its material
        setFile(origin);
        isRecovered_ = true;
        document_.undoStack().resetClean();
    }
    return opened;
}

bool DocumentFiles::openPreset(const std::filesystem::path& path, const ReadingRights& rights) {
    const Checked<PresetReading> reading = readPreset(path, document_.catalog(), rights);
    if (!reading) {
        report(reading.error());
        return false;
    }
    DocumentState state = document_.state();
    state.preview.reset();
    if (!hasSecondMaterial(state)) {
        state.second.reset();
    }
    state.picture.reset();
    if (state.scene.objects.empty()) {
        state.scene.objects.emplace_back();
    }
    const int object = std::max(document_.selection().object(), 0);
    const DocumentState saved = savedState_;
    const bool keepsChanges = document_.isModified() && withoutMaterial(state, object).scene !=
                                                            withoutMaterial(saved, object).scene;
    *materialAt(state, object, Side::A) = reading->material;
    start(std::move(state), {DocumentFile::Kind::Preset, path, reading->readOnly}, object);
    if (keepsChanges) { // of the scene around it, which closing must still ask about
        savedState_ = saved;
        document_.undoStack().resetClean();
    }
    report(reading->notes);
    return true;
}

bool DocumentFiles::applyPreset(const std::filesystem::path& path, Side side,
                                const ReadingRights& rights) {
    const Checked<PresetReading> reading = readPreset(path, document_.catalog(), rights);
    if (!reading) {
        report(reading.error());
        return false;
    }
    if (side == Side::B && !document_.state().second) {
        setSecondMaterial(document_, reading->material);
    } else {
        document_.replaceMaterials(side, reading->material, tr("Preset %1").arg(titleOf(path)));
    }
    report(reading->notes);
    return true;
}

Scene DocumentFiles::sceneToRecover() const {
    Scene scene = sceneToSave();
    nlohmann::json withheld = nlohmann::json::array();
    for (const OutsideFile& each : withheld_.all()) {
        withheld.push_back({{"kind", static_cast<int>(each.kind)}, {"file", each.file}});
    }
    scene.extras[withheldKey] = std::move(withheld);
    return scene;
}

Scene DocumentFiles::sceneToSave() const {
    Scene scene = document_.state().scene;
    const int object = document_.state().preview ? document_.state().preview->object : -1;
    if (const std::optional<Material> own = materialAside(document_.state(), object)) {
        scene.objects[static_cast<std::size_t>(object)].material = *own;
    }
    if (!document_.state().snapshots.empty()) {
        scene.extras[snapshotsKey] = snapshotsToJson(document_.state().snapshots);
    }
    return hasSecondMaterial(document_.state())
               ? withCompared(std::move(scene), document_.state(), document_.selection().object())
               : scene;
}

bool DocumentFiles::isOwnFile(const std::filesystem::path& path) const {
    std::error_code ignored; // it is no file yet
    return path == file_.path || std::filesystem::equivalent(path, file_.path, ignored);
}

bool DocumentFiles::mayOverwrite(const std::filesystem::path& path) {
    if (isShippedPreset(path)) {
        Q_EMIT message({path.string(), 0, 0, "the file comes with Patina and stays as it is",
                        "another file name or folder"});
        return false;
    }
    if (file_.readOnly && isOwnFile(path)) {
        Q_EMIT message({path.string(), 0, 0, "the file was written by a newer version of Patina",
                        "another file name, so that nothing in it is lost"});
        return false;
    }
    return true;
}

bool DocumentFiles::saveScene(const std::filesystem::path& path) {
    if (!mayOverwrite(path)) {
        return false;
    }
    Scene saved = sceneToSave();
    if (!isOwnFile(path)) {                       // under another name it is another scene
        saved.name = path.stem().stem().string(); // without .patina-scene.json
    }
    const Result<void> written = writeScene(path, saved);
    if (!written) {
        Q_EMIT message(written.error());
        return false;
    }
    document_.nameScene(saved.name);
    for (const Object& object : document_.state().scene.objects) {
        report(imagesOutside(object.material, path));
    }
    savedState_ = document_.state();
    isRecovered_ = false;
    document_.undoStack().setClean();
    setFile({DocumentFile::Kind::Scene, path, false});
    return true;
}

bool DocumentFiles::savePreset(const std::filesystem::path& path, Side side) {
    const Material* held = document_.material(side);
    return held && savePreset(path, side, held->name);
}

bool DocumentFiles::savePreset(const std::filesystem::path& path, Side side,
                               const std::string& name) {
    const Material* held = document_.material(side);
    if (!held) {
        return false;
    }
    Material saved = *held;
    saved.name = name;
    return savePreset(path, pathOf(settings::material, document_.selection().object(), side),
                      saved);
}

/// Renames the material in the document only once its file is written.
bool DocumentFiles::savePreset(const std::filesystem::path& path, const BlockPath& of,
                               const Material& saved) {
    if (!mayOverwrite(path)) {
        return false;
    }
    Material kept = saved;
    if (const auto own = materialAside(document_.state(), of.index); own && of.side == Side::A) {
        kept = *own;
        kept.name = saved.name;
    }
    const bool keeps = keepsParked_ || holdsParked(path, document_.catalog());
    const Result<void> written = writePreset(
        path, keeps ? kept : withoutParked(kept, document_.catalog()), document_.catalog());
    if (!written) {
        Q_EMIT message(written.error());
        return false;
    }
    report(imagesOutside(saved, path));
    if (file_.kind != DocumentFile::Kind::Scene) {
        if (!(*materialAt(document_.state(), of.index, of.side) == saved)) {
            const QString label = tr("Name %1").arg(QString::fromStdString(saved.name));
            document_.undoStack().push(
                new MaterialCommand(document_, {of.index, of.side}, saved, label));
        }
        if (of.side == Side::A) {
            presetObject_ = of.index;
            setFile({DocumentFile::Kind::Preset, path, false});
        }
    }
    markPresetSaved(of.side);
    return true;
}

bool DocumentFiles::outgrewPreset() const {
    return file_.kind == DocumentFile::Kind::Preset &&
           withoutMaterial(document_.state(), presetObject_) !=
               withoutMaterial(savedState_, presetObject_);
}

/// The document is clean only when the preset held everything that changed: lights, fog and
/// objects belong to a scene file, and closing must still ask about them.
void DocumentFiles::markPresetSaved(Side side) {
    if (file_.kind == DocumentFile::Kind::Scene) {
        return; // an export
    }
    if (side == Side::B) {
        savedState_.second = document_.state().second;
    } else if (side != Side::A) {
        savedState_.further = document_.state().further;
    }
    const bool everything = withoutMaterial(document_.state(), presetObject_) ==
                            withoutMaterial(savedState_, presetObject_);
    if (everything && (side == Side::A || *materialAt(document_.state(), presetObject_, Side::A) ==
                                              *materialAt(savedState_, presetObject_, Side::A))) {
        isRecovered_ = false;
        document_.undoStack().setClean();
    }
    if (Material* savedMaterial = materialAt(savedState_, presetObject_, Side::A);
        savedMaterial && side == Side::A) {
        *savedMaterial = *materialAt(document_.state(), presetObject_, Side::A);
    }
}

bool DocumentFiles::save() {
    switch (file_.kind) {
    case DocumentFile::Kind::Preset:
        if (const Material* held = materialAt(document_.state(), presetObject_, Side::A)) {
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
