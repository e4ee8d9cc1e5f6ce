// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_actions.h"

#include <algorithm>
#include <numeric>

#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMessageBox>
#include <QRegularExpression>

#include "document/scene_edits.h"
#include "files/details_dialog.h"
#include "files/import_dialog.h"
#include "files/place_beside.h"
#include "library/preset_library.h"
#include "material/file_suffixes.h"
#include "material/mesh_look.h"
#include "measured/measured_reflectance.h"
#include "resources/texture_library.h"
#include "scene/scene_file.h"
#include "sheet/sheet_file.h"
#include "text/as_text.h"

namespace patina {
namespace {

const QString presetEnding = asText(presetSuffix);
const QString sceneEnding = asText(sceneSuffix);

constexpr int maxNameBytes = 160;

QString presetFilter() {
    return QObject::tr("Patina presets (*.patina.json)");
}

QString sceneFilter() {
    return QObject::tr("Patina scenes (*.patina-scene.json)");
}

/// Returns when a file was written; empty if it does not exist.
std::optional<std::filesystem::file_time_type> timeOf(const std::filesystem::path& file) {
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(file, missing);
    return missing ? std::nullopt : std::optional(time);
}

/// Returns the folder of the user's presets after creating it; a dialog starts elsewhere if that
/// fails.
QString madePresetFolder() {
    const std::filesystem::path folder = PresetLibrary::userFolder();
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    return QString::fromStdString(folder.string());
}

/// Cuts a name to 160 bytes of UTF-8, so that it fits into 255 with an ending.
QString fitting(QString name) {
    while (name.toUtf8().size() > maxNameBytes) {
        name.chop(name.back().isLowSurrogate() ? 2 : 1);
    }
    return name;
}

QString withSuffix(QString file, const QString& suffix) {
    if (file.isEmpty() || file.endsWith(suffix)) {
        return file;
    }
    const QString json = QStringLiteral(".json");
    return (file.endsWith(json) ? file.chopped(json.size()) : file) + suffix;
}

} // namespace

FileActions::FileActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                         TextureLibrary& textures, Session& session, QWidget* window)
    : QObject(window), document_(document), files_(files), meshes_(meshes), textures_(textures),
      session_(session), clipboard_(new ClipboardActions(document, files, meshes, this)),
      consent_(session, window), window_(window) {
    connect(&meshes, &MeshLibrary::loaded, this, &FileActions::meshLoaded);
    connect(&meshes, &MeshLibrary::failed, this, &FileActions::meshFailed);
    connect(&meshes, &MeshLibrary::linksRefused, this, &FileActions::noteLinks);
    connect(&document, &Document::fileNamed, this, [this](const std::filesystem::path& file) {
        if (isMeasuredFile(file)) {
            textures_.readTable(file); // as soon as a value names it, so that a failure is told
        }
    });
    connect(&files, &DocumentFiles::fileChanged, this,
            [this] { written_ = timeOf(files_.file().path); });
}

/// Has the measured files among these read in the background before it goes on; with none it goes
/// on at once.
void FileActions::whenRead(const QStringList& files, const std::function<void()>& next) {
    const auto measured = std::ranges::find_if(
        files, [](const QString& file) { return isMeasuredFile(file.toStdString()); });
    if (measured == files.end()) {
        next();
        return;
    }
    const QStringList rest(measured + 1, files.end());
    textures_.readTable(measured->toStdString(), [this, rest, next] { whenRead(rest, next); });
}

void FileActions::newDocument() {
    if (mayLoseDocument()) {
        files_.openTemplate(defaultSceneFile());
        forgetMeshes();
        Q_EMIT documentReplaced();
    }
}

bool FileActions::save() {
    const DocumentFile& file = files_.file();
    if (file.kind == DocumentFile::Kind::None || file.readOnly || files_.outgrewPreset() ||
        isShippedPreset(file.path)) {
        return saveAs();
    }
    // Saves even if nothing was edited: moving the camera is no edit, and the file may be gone.
    const bool isSaved = mayReplaceChanged(file.path) && files_.save();
    if (isSaved) {
        noteSaved(QString::fromStdString(file.path.string()));
    }
    return isSaved;
}

bool FileActions::saveAs() {
    const bool isPreset =
        files_.file().kind == DocumentFile::Kind::Preset && !files_.outgrewPreset();
    QString filter = isPreset ? presetFilter() : sceneFilter();
    QString file = QFileDialog::getSaveFileName(window_, tr("Save As"), suggestedFile(),
                                                sceneFilter() + ";;" + presetFilter(), &filter);
    if (file.isEmpty()) {
        return false;
    }
    const bool asPreset =
        file.endsWith(presetEnding) || (!file.endsWith(sceneEnding) && filter == presetFilter());
    const QString asked = file;
    file = withSuffix(file, asPreset ? presetEnding : sceneEnding);
    if (!mayReplace(asked, file)) {
        return false;
    }
    const bool isSaved = asPreset ? writePreset(file) : files_.saveScene(file.toStdString());
    if (isSaved) {
        session_.setFolderOf("scene", file);
        noteSaved(file);
    }
    return isSaved;
}

/// A preset may hold less than what was changed.
void FileActions::noteSaved(const QString& file) {
    session_.addRecentFile(file);
    consent_.noteSaved(
        file, file.endsWith(presetEnding) ? DocumentFile::Kind::Preset : DocumentFile::Kind::Scene,
        document_.catalog(), files_.withheld());
    if (!document_.isModified()) {
        Q_EMIT saved();
        return;
    }
    report({file.toStdString(), 0, 0,
            "the preset is saved, but lights, fog, objects and side B are not part of it",
            "Save As with a scene file to keep them too"});
}

void FileActions::askAndOpen() {
    const QStringList files = QFileDialog::getOpenFileNames(
        window_, tr("Open"), session_.folder("open"),
        tr("Presets, scenes and meshes") +
            " (*.json *.obj *.gltf *.glb *.ply *.stl *.fbx *.dae *.3ds *.blend *.off"
            " *.hdr *.exr *.binary *.bsdf);;" +
            tr("All files") + " (*)");
    if (!files.isEmpty()) {
        session_.setFolderOf("open", files.front());
        open(files, document_.selection().side());
    }
}

void FileActions::exportPreset() {
    const Material* material = document_.material(document_.selection().side());
    if (!material) {
        return;
    }
    const QString name = asFileName(QString::fromStdString(material->name)) + presetEnding;
    const QString start = madePresetFolder() + '/' + name;
    const QString asked = QFileDialog::getSaveFileName(window_, tr("Save the material as a preset"),
                                                       start, presetFilter());
    const QString file = withSuffix(asked, presetEnding);
    if (!file.isEmpty() && mayReplace(asked, file) && writePreset(file)) {
        session_.addRecentFile(file);
        consent_.noteSaved(file, DocumentFile::Kind::Preset, document_.catalog(),
                           files_.withheld());
    }
}

/// Writes a preset. Under another file name the material gets that name, since it is another
/// preset.
bool FileActions::writePreset(const QString& file) {
    const Side side = document_.selection().side();
    const Material* material = document_.material(side);
    if (!material) {
        return false;
    }
    const QString held = QString::fromStdString(material->name);
    const QString name = QFileInfo(file).fileName().chopped(presetEnding.size());
    const bool isSameFile = files_.file().path == file.toStdString();
    const bool staysCalled = !held.isEmpty() && (isSameFile || name == asFileName(held) ||
                                                 name.compare(held, Qt::CaseInsensitive) == 0);
    return files_.savePreset(file.toStdString(), side, (staysCalled ? held : name).toStdString());
}

void FileActions::importMesh() {
    const QStringList files = QFileDialog::getOpenFileNames(
        window_, tr("Import mesh"), session_.folder("mesh"), tr("All files") + " (*)");
    if (files.isEmpty() || !askHowToImport(files.front())) {
        return;
    }
    for (const QString& file : files) {
        session_.setFolderOf("mesh", file);
        load(file);
    }
}

/// Returns false if the user cancels.
bool FileActions::askHowToImport(const QString& file) {
    if (QGuiApplication::queryKeyboardModifiers().testFlag(Qt::ShiftModifier)) {
        return true;
    }
    ImportDialog dialog(file, session_.meshImport(), window_);
    if (dialog.exec() != QDialog::Accepted) {
        return false;
    }
    session_.setMeshImport(dialog.chosen());
    return true;
}

Object FileActions::withCurrentMaterial(Object object) const {
    if (const Material* material = document_.material(Side::A)) {
        object.material = *material;
    } else if (const auto start = readScene(defaultSceneFile(), document_.catalog());
               start && !start->scene.objects.empty()) {
        object.material = start->scene.objects.front().material;
    }
    return object;
}

void FileActions::addObject(const Object& object) {
    patina::addObject(document_, withCurrentMaterial(object)); // makes it current, too
}

void FileActions::addBeside(const Object& object) {
    document_.editAsOneStep(tr("Add %1").arg(QString::fromStdString(object.name)), [&] {
        addObject(placedBeside(document_.scene(), object, meshes_));
        Q_EMIT meshPlaced();
    });
}

void FileActions::duplicateObjects() {
    const Scene& scene = document_.scene();
    std::vector<Object> copies;
    for (const int index : document_.selection().editedObjects()) {
        copies.push_back(scene.objects[static_cast<std::size_t>(index)]);
    }
    addObjects(document_, placedBeside(scene, copies, meshes_),
               tr("Duplicate %n object(s)", nullptr, static_cast<int>(copies.size())));
}

/// Forgets the meshes that were being loaded for the former document.
void FileActions::forgetMeshes() {
    wanted_.clear();
    meshes_.forgetFailures();
    meshes_.cancelAllBut(document_.scene());
}

/// Adds the object once its mesh is loaded, with the choices of the last import. A mesh that cannot
/// be read changes nothing.
void FileActions::load(const QString& mesh) {
    const MeshImport import = session_.meshImport();
    Object object;
    object.name = QFileInfo(mesh).completeBaseName().toStdString();
    object.mesh = QFileInfo(mesh).absoluteFilePath().toStdString();
    object.fitUnitBox = import.fits;
    object.flipNormals = import.flips;
    object.scale = glm::dvec3(import.scale);
    object.rotation.x = import.isZUp ? -90.0 : 0.0;
    const QString file = QString::fromStdString(object.mesh);
    wanted_[file] = {object, import.joins};
    files_.withheld().allow(object.mesh);
    meshes_.forgetFailures();
    if (!import.joins) {
        meshes_.readApart(object);
        return;
    }
    meshes_.view(object);
    if (meshes_.has(object)) {
        meshLoaded(file);
    }
}

void FileActions::meshLoaded(const QString& mesh) {
    if (const auto found = wanted_.find(mesh); found != wanted_.end()) {
        const Wanted wanted = found->second;
        std::vector<Object> objects = objectsOf(wanted.object);
        if (!wanted.joins && objects.empty()) {
            return; // the whole was read for another object, its parts are on their way
        }
        wanted_.erase(found);
        if (wanted.joins || objects.empty()) {
            objects = {withCurrentMaterial(wanted.object)};
        }
        const bool isInPlace = showsOnlyTheStart();
        document_.editAsOneStep(tr("Add %1").arg(QString::fromStdString(wanted.object.name)), [&] {
            place(objects, isInPlace);
            Q_EMIT meshPlaced();
        });
        session_.addRecentFile(mesh);
    }
}

/// Puts the objects of a mesh in place of the one in a new document, or beside all others.
void FileActions::place(const std::vector<Object>& objects, bool isInPlace) {
    if (isInPlace) {
        replaceObject(objects);
        return;
    }
    const std::vector<Object> placed = placedBeside(document_.scene(), objects, meshes_);
    if (placed.size() == 1) {
        patina::addObject(document_, placed.front());
    } else {
        patina::addObjects(document_, placed, tr("Add objects"));
    }
}

/// Returns an object for each material of a mesh that was read apart, with the preset that looks as
/// the file says, or with the current material where the file says nothing.
std::vector<Object> FileActions::objectsOf(const Object& mesh) const {
    std::vector<Object> objects;
    const std::vector<MeshMaterial> materials = meshes_.materialsOf(mesh);
    for (const MeshMaterial& from : materials) {
        Object object = withCurrentMaterial(mesh);
        if (materials.size() > 1) {
            object.name = from.name;
            object.part = from.name;
            object.group = mesh.name;
        }
        if (auto material = materialOf(from, document_.catalog()); material && !from.look.empty()) {
            object.material = std::move(*material);
        }
        objects.push_back(std::move(object));
    }
    return objects;
}

/// Returns whether the document shows one of the scenes that ship, as a new one does, whatever its
/// material and camera.
bool FileActions::showsOnlyTheStart() const {
    const Scene& shown = document_.scene();
    if (document_.undoStack().count() > 0 || document_.isModified() ||
        files_.file().kind == DocumentFile::Kind::Scene || shown.objects.size() != 1) {
        return false;
    }
    return std::ranges::any_of(shippedScenes(), [&](const std::filesystem::path& file) {
        auto start = readScene(file, document_.catalog());
        if (!start || start->scene.objects.size() != 1) {
            return false;
        }
        start->scene.camera = shown.camera;
        start->scene.objects.front().material = shown.objects.front().material;
        return start->scene == shown;
    });
}

/// Replaces the only object.
void FileActions::replaceObject(const std::vector<Object>& objects) {
    if (objects.size() == 1) {
        patina::setObject(document_, 0, objects.front());
        document_.selection().setObject(0);
        return;
    }
    patina::addObjects(document_, objects, tr("Add objects"));
    patina::removeObjects(document_, {0});
    std::vector<int> all(objects.size());
    std::iota(all.begin(), all.end(), 0);
    document_.selection().setObjects(all);
}

void FileActions::meshFailed(const QString& mesh, const Error& why) {
    wanted_.erase(mesh);
    report(why);
}

void FileActions::noteLinks(const QString& mesh, const std::vector<std::string>& places) {
    files_.withheld().addLinks(places);
    tellOutside(mesh);
}

void FileActions::editDetails() {
    const Side side = document_.selection().side();
    const Material* material = document_.material(side);
    if (!material) {
        return;
    }
    DetailsDialog dialog(*material, window_);
    if (dialog.exec() == QDialog::Accepted) {
        document_.replaceMaterial(side, dialog.edited(), tr("Change details"));
    }
}

/// Asks if another program has written the file since it was opened or saved here.
bool FileActions::mayReplaceChanged(const std::filesystem::path& file) {
    const auto written = timeOf(file);
    return !written || written == written_ ||
           QMessageBox::warning(window_, tr("Save"),
                                tr("%1 was changed by another program since it was opened. "
                                   "Replace it?")
                                    .arg(QString::fromStdString(file.filename().string())),
                                QMessageBox::Yes | QMessageBox::No,
                                QMessageBox::No) == QMessageBox::Yes;
}

/// Asks again if a suffix was added, since the file dialog asked about the name without it.
bool FileActions::mayReplace(const QString& asked, const QString& file) {
    return file == asked || !QFileInfo::exists(file) ||
           QMessageBox::warning(
               window_, tr("Save"),
               tr("%1 already exists. Replace it?").arg(QFileInfo(file).fileName()),
               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

void FileActions::open(const QStringList& files, Side side) {
    whenRead(files, [this, files, side] { openRead(files, side); });
}

void FileActions::openRead(const QStringList& files, Side side) {
    QStringList documents;
    QStringList meshes; // these and what follows belong to the document that is opened
    QStringList others;
    for (const QString& file : files) {
        if (kindOf(file) == Kind::Mesh) {
            meshes << file;
        } else if (kindOf(file) == Kind::Panorama || kindOf(file) == Kind::Sheet) {
            others << file;
        } else {
            documents << file;
        }
    }
    if (!documents.isEmpty()) {
        openDocument(documents.takeFirst());
    }
    if (!documents.isEmpty() && kindOf(documents.front()) == Kind::Preset) {
        applyRead(documents.takeFirst(), side == Side::A ? Side::B : Side::A);
    }
    for (const QString& mesh : meshes) {
        load(mesh);
    }
    for (const QString& file : documents) {
        report({file.toStdString(), 0, 0, "is not opened: there is room for one scene or preset",
                "beside it a preset for the other side, and meshes"});
    }
    dropRead(others, side);
}

void FileActions::drop(const QStringList& files, Side side) {
    whenRead(files, [this, files, side] { dropRead(files, side); });
}

void FileActions::dropRead(const QStringList& files, Side side) {
    for (const QString& file : files) {
        switch (kindOf(file)) {
        case Kind::Preset:
            applyRead(file, side);
            document_.selection().setSide(side); // what was put there is what is worked on next
            break;
        case Kind::Scene:
            openDocument(file);
            break;
        case Kind::Panorama:
            patina::setEnvironmentPicture(document_,
                                          QFileInfo(file).absoluteFilePath().toStdString());
            break;
        case Kind::Mesh:
            load(file);
            break;
        case Kind::Sheet:
            document_.selection().setSide(side);
            Q_EMIT sheetWished(file);
            break;
        }
    }
}

void FileActions::applyPreset(const QString& file, Side side) {
    whenRead({file}, [this, file, side] { applyRead(file, side); });
}

void FileActions::applyRead(const QString& file, Side side) {
    const ReadingRights rights =
        consent_.rightsFor(file, DocumentFile::Kind::Preset, document_.catalog());
    if (files_.applyPreset(file.toStdString(), side, rights)) {
        Q_EMIT presetApplied(file);
    }
}

void FileActions::allowOutside() {
    const OutsideFiles wanted = files_.withheld().all();
    const QString file = QString::fromStdString(files_.file().path.string());
    if (!wanted.empty() && consent_.ask(file, wanted)) {
        files_.withheld().allowAll(files_.file().path);
    }
}

bool FileActions::mayLoseDocument() {
    if (!document_.isModified()) {
        return true;
    }
    QMessageBox question(QMessageBox::Question, tr("Unsaved changes"), questionText(),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    question.setInformativeText(files_.isRecovered()
                                    ? tr("The recovered work is offered again at the next start "
                                         "if you do not save it.")
                                    : tr("They are lost if you do not save them."));
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Save) {
        return save() && mayLoseDocument(); // asks again when a preset held only a part of it
    }
    return answer == QMessageBox::Discard;
}

QString FileActions::questionText() const {
    const QString file = QString::fromStdString(files_.file().path.filename().string());
    if (files_.outgrewPreset()) {
        return tr("Save the changes as a scene? %1 is a preset, which holds a material and no "
                  "lights, fog, objects or side B.")
            .arg(file);
    }
    if (isShippedPreset(files_.file().path)) {
        return tr("Save the changes to a copy? %1 comes with Patina and stays as it is.").arg(file);
    }
    return tr("Save the changes to %1?").arg(file.isEmpty() ? tr("the untitled scene") : file);
}

FileActions::Kind FileActions::kindOf(const QString& file) {
    if (file.endsWith(sceneEnding, Qt::CaseInsensitive)) {
        return Kind::Scene;
    }
    if (file.endsWith(QString::fromStdString(std::string(sheetEnding)), Qt::CaseInsensitive)) {
        return Kind::Sheet;
    }
    for (const QString& panorama : {QStringLiteral(".hdr"), QStringLiteral(".exr")}) {
        if (file.endsWith(panorama, Qt::CaseInsensitive)) {
            return Kind::Panorama;
        }
    }
    if (isMeasuredFile(file.toStdString())) {
        return Kind::Preset;
    }
    if (!file.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive)) {
        return Kind::Mesh;
    }
    const bool isNamed = file.endsWith(presetEnding, Qt::CaseInsensitive);
    return !isNamed && saysItIsAScene(file.toStdString()) ? Kind::Scene : Kind::Preset;
}

QString FileActions::asFileName(const QString& name) {
    QString safe = name.trimmed().toLower();
    safe.replace(QRegularExpression(QStringLiteral("[^\\w.-]+"),
                                    QRegularExpression::UseUnicodePropertiesOption),
                 QStringLiteral("-"));
    return safe.isEmpty() ? QStringLiteral("untitled") : fitting(safe);
}

void FileActions::openDocument(const QString& file) {
    if (!mayLoseDocument()) {
        return;
    }
    const bool isScene = kindOf(file) == Kind::Scene;
    const ReadingRights rights =
        consent_.rightsFor(file, isScene ? DocumentFile::Kind::Scene : DocumentFile::Kind::Preset,
                           document_.catalog());
    const bool opened = isScene ? files_.openScene(file.toStdString(), rights)
                                : files_.openPreset(file.toStdString(), rights);
    if (opened) {
        forgetMeshes();
        meshes_.repeatMissingLinks(document_.scene());
        session_.addRecentFile(file);
        tellOutside(file);
        Q_EMIT documentReplaced();
    }
}

void FileActions::tellOutside(const QString& file) {
    if (!files_.withheld().all().empty()) {
        report({file.toStdString(), 0, 0, "names files outside its folder, which are not read",
                "File > Allow Files Outside, where you trust it"});
    }
}

/// Suggests a copy of files that come with Patina; a preset goes among the user's own.
QString FileActions::suggestedFile() const {
    const std::filesystem::path& path = files_.file().path;
    const std::filesystem::path folder = path.parent_path();
    if (isShippedPreset(path)) {
        const bool isPreset =
            files_.file().kind == DocumentFile::Kind::Preset && !files_.outgrewPreset();
        return isPreset ? madePresetFolder() + '/' + nameOfCopy() + presetEnding
                        : session_.folder("scene") + '/' + nameOfCopy() + sceneEnding;
    }
    return (folder.empty() ? session_.folder("scene") : QString::fromStdString(folder.string())) +
           '/' + suggestedName();
}

/// Returns "Copy of" with the name in its own case, as it becomes the name of the copy.
QString FileActions::nameOfCopy() const {
    const Material* material = document_.material(Side::A);
    const bool isPreset = files_.file().kind == DocumentFile::Kind::Preset;
    const std::string& name = isPreset && material ? material->name : document_.scene().name;
    const QString stem = QString::fromStdString(files_.file().path.filename().string());
    const QString called = name.empty() ? stem.section('.', 0, 0) : QString::fromStdString(name);
    return fitting(tr("Copy of %1").arg(called).replace('/', '-'));
}

QString FileActions::suggestedName() const {
    const std::filesystem::path& path = files_.file().path;
    if (!path.empty()) {
        const QString name = QString::fromStdString(path.filename().string());
        if (isMeasuredFile(path)) {
            return QString::fromStdString(path.stem().string()) +
                   (files_.outgrewPreset() ? sceneEnding : presetEnding);
        }
        return files_.outgrewPreset() && name.endsWith(presetEnding)
                   ? name.chopped(presetEnding.size()) + sceneEnding
                   : name;
    }
    return asFileName(QString::fromStdString(document_.scene().name)) + sceneEnding;
}

} // namespace patina
