// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with meshes: importing, placing, replacing.
#include <QFileDialog>
#include <QFileInfo>

#include "document/scene_edits.h"
#include "files/file_actions.h"
#include "scene/scene_file.h"
#include "viewport/place_beside.h"

namespace patina {

void FileActions::importMesh() {
    const QStringList files = QFileDialog::getOpenFileNames(
        window_, tr("Import mesh"), session_.folder("mesh"), tr("All files") + " (*)");
    for (const QString& file : files) {
        session_.setFolderOf("mesh", file);
        load(file);
    }
}

void FileActions::addObject(Object object) {
    if (const Material* material = document_.material(Side::A)) {
        object.material = *material;
    } else if (const auto start = readScene(defaultSceneFile(), document_.catalog());
               start && !start->scene.objects.empty()) {
        object.material = start->scene.objects.front().material;
    }
    patina::addObject(document_, object); // which makes it the current one
}

void FileActions::addBeside(const Object& object) {
    document_.editAsOneStep(tr("Add %1").arg(QString::fromStdString(object.name)), [&] {
        addObject(placedBeside(document_.scene(), object, meshes_));
        Q_EMIT meshPlaced();
    });
}

/// What was on its way for the former document.
void FileActions::forgetMeshes() {
    wanted_.clear();
    meshes_.forgetFailures();
    meshes_.cancelAllBut(document_.scene());
}

/// The object is added when its mesh is there; a mesh that cannot be read changes nothing.
void FileActions::load(const QString& mesh) {
    Object object;
    object.name = QFileInfo(mesh).completeBaseName().toStdString();
    object.mesh = QFileInfo(mesh).absoluteFilePath().toStdString();
    object.fitUnitBox = true;
    const QString file = QString::fromStdString(object.mesh);
    wanted_[file] = object;
    files_.withheld().allow(object.mesh);
    meshes_.forgetFailures();
    meshes_.view(object);
    if (meshes_.has(object)) {
        meshLoaded(file);
    }
}

void FileActions::meshLoaded(const QString& mesh) {
    if (const auto found = wanted_.find(mesh); found != wanted_.end()) {
        const Object object = found->second;
        wanted_.erase(found);
        if (showsOnlyTheStart()) {
            document_.editAsOneStep(tr("Add %1").arg(QString::fromStdString(object.name)), [&] {
                replaceObject(object);
                Q_EMIT meshPlaced();
            });
        } else {
            addBeside(object);
        }
        session_.addRecentFile(mesh);
    }
}

/// True while the document shows what a new one does, whatever its material and camera.
bool FileActions::showsOnlyTheStart() const {
    const auto start = readScene(defaultSceneFile(), document_.catalog());
    Scene shown = document_.scene();
    if (document_.undoStack().count() > 0 || document_.isModified() ||
        files_.file().kind == DocumentFile::Kind::Scene || !start || shown.objects.size() != 1 ||
        start->scene.objects.size() != 1) {
        return false;
    }
    shown.camera = start->scene.camera;
    shown.objects.front().material = start->scene.objects.front().material;
    return shown == start->scene;
}

/// Puts an object in place of the only one, with its material.
void FileActions::replaceObject(Object object) {
    object.material = document_.scene().objects.front().material;
    patina::setObject(document_, 0, object);
    document_.setCurrentObject(0);
}

void FileActions::meshFailed(const QString& mesh, const Error& why) {
    wanted_.erase(mesh);
    tell(why);
}

} // namespace patina
