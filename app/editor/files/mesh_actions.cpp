// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/mesh_actions.h"

#include <algorithm>
#include <numeric>

#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

#include "document/scene_edits.h"
#include "files/embedded_images.h"
#include "files/import_dialog.h"
#include "files/place_beside.h"
#include "material/mesh_look.h"
#include "resources/mesh_library.h"
#include "scene/scene_file.h"
#include "session/session.h"
#include "text/counted.h"

namespace patina {

MeshActions::MeshActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                         Session& session, QWidget* window)
    : document_(document), files_(files), meshes_(meshes), session_(session), window_(window) {
    connect(&meshes, &MeshLibrary::loaded, this, &MeshActions::meshLoaded);
    connect(&meshes, &MeshLibrary::failed, this, &MeshActions::meshFailed);
}

void MeshActions::askAndImport() {
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
bool MeshActions::askHowToImport(const QString& file) {
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

Object MeshActions::withCurrentMaterial(Object object) const {
    if (const Material* material = document_.material(Side::A)) {
        object.material = *material;
    } else if (const auto start = readScene(defaultSceneFile(), document_.catalog());
               start && !start->scene.objects.empty()) {
        object.material = start->scene.objects.front().material;
    }
    return object;
}

void MeshActions::addObject(const Object& object) {
    patina::addObject(document_, withCurrentMaterial(object)); // makes it current, too
}

void MeshActions::addBeside(const Object& object) {
    document_.editAsOneStep(tr("Add %1").arg(QString::fromStdString(object.name)), [&] {
        addObject(placedBeside(document_.scene(), object, meshes_));
        Q_EMIT placed();
    });
}

void MeshActions::duplicateObjects() {
    const Scene& scene = document_.scene();
    std::vector<Object> copies;
    for (const int index : document_.selection().editedObjects()) {
        copies.push_back(scene.objects[static_cast<std::size_t>(index)]);
    }
    addObjects(document_, placedBeside(scene, copies, meshes_),
               counted(copies.size(), tr("Duplicate object"), tr("Duplicate %1 objects")));
}

void MeshActions::forget() {
    wanted_.clear();
    meshes_.forgetFailures();
    meshes_.cancelAllBut(document_.scene());
}

void MeshActions::load(const QString& mesh) {
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

void MeshActions::meshLoaded(const QString& mesh) {
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
            Q_EMIT placed();
        });
        session_.addRecentFile(mesh);
    }
}

/// Puts the objects of a mesh in place of the one in a new document, or beside all others.
void MeshActions::place(const std::vector<Object>& objects, bool isInPlace) {
    if (isInPlace) {
        replaceObject(objects);
        return;
    }
    const std::vector<Object> placed = placedBeside(document_.scene(), objects, meshes_);
    if (placed.size() == 1) {
        patina::addObject(document_, placed.front());
    } else {
        patina::addObjects(document_, placed,
                           counted(placed.size(), tr("Add object"), tr("Add %1 objects")));
    }
}

/// Returns an object for each material of a mesh that was read apart, with the preset that looks as
/// the file says, or with the current material where the file says nothing.
std::vector<Object> MeshActions::objectsOf(const Object& mesh) const {
    std::vector<Object> objects;
    std::vector<MeshMaterial> materials = meshes_.materialsOf(mesh);
    for (MeshMaterial& from : materials) {
        for (const Error& error : keepEmbeddedImages(from, userDataFolder() / "images")) {
            Q_EMIT files_.message(error);
        }
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
bool MeshActions::showsOnlyTheStart() const {
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
void MeshActions::replaceObject(const std::vector<Object>& objects) {
    if (objects.size() == 1) {
        patina::setObject(document_, 0, objects.front());
        document_.selection().setObject(0);
        return;
    }
    patina::addObjects(document_, objects,
                       counted(objects.size(), tr("Add object"), tr("Add %1 objects")));
    patina::removeObjects(document_, {0});
    std::vector<int> all(objects.size());
    std::iota(all.begin(), all.end(), 0);
    document_.selection().setObjects(all);
}

void MeshActions::meshFailed(const QString& mesh, const Error& why) {
    wanted_.erase(mesh);
    Q_EMIT files_.message(why);
}

} // namespace patina
