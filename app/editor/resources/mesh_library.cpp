// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/mesh_library.h"

#include <algorithm>
#include <utility>

#include <QFileInfo>

#include "background/tell_afterwards.h"
#include "scene/builtin_mesh.h"
#include "scene/kept_openness.h"
#include "scene/mesh_path.h"

namespace patina {
namespace {

QString fileName(const MeshKey& key) {
    return QFileInfo(QString::fromStdString(key.mesh)).fileName();
}

/// Returns the key under which a mesh is read: all parts of a mesh are read at once.
MeshKey readingOf(MeshKey key) {
    key.part = key.part.empty() ? "" : "*";
    return key;
}

} // namespace

MeshLibrary::MeshLibrary(QObject* parent)
    : QObject(parent),
      opennessWorker_(
          {.name = tr("Finding occlusion"), .canCancel = true, .priority = QThread::LowPriority}),
      worker_({.name = tr("Reading a mesh"), .canCancel = true}) {}

MeshView MeshLibrary::view(const Object& object) {
    const MeshKey key = meshKey(object);
    MeshView view = triangles(key);
    if (!view.indices.empty()) {
        addOpenness(view, key);
    }
    return view;
}

void MeshLibrary::wantOpenness(bool wanted) {
    wantsOpenness_ = wanted;
    if (!wanted && !finding_.empty()) {
        opennessWorker_.forget();
        finding_.clear();
        Q_EMIT opennessFound();
    }
}

MeshView MeshLibrary::triangles(const MeshKey& key) {
    if (builtinName(key.mesh)) {
        if (!builtins_.contains(key)) {
            makeBuiltin(key);
        }
        return builtins_.at(key).view();
    }
    if (const auto found = files_.find(key); found != files_.end()) {
        return found->second->view;
    }
    const MeshKey reading = readingOf(key);
    if (key.mesh.empty() || loading_.contains(reading) || failures_.contains(reading) ||
        failures_.contains(key)) {
        return {};
    }
    if (materials_.contains(reading)) {
        failures_[key] = missingPart(key.mesh, key.part);
        tellAfterwards(*this, [this, why = failures_[key]] {
            Q_EMIT failed(QString::fromStdString(why.file), why);
        });
        return {};
    }
    load(reading);
    return {};
}

void MeshLibrary::addOpenness(MeshView& view, const MeshKey& key) {
    const auto found = found_.find(key);
    if (found != found_.end() && found->second->vertices == view.vertices.data()) {
        view.openness = found->second->openness;
    } else if (wantsOpenness_ && !finding_.contains(key)) {
        findOpenness(view, key);
    }
}

void MeshLibrary::findOpenness(const MeshView& view, const MeshKey& key) {
    const auto file = files_.find(key);
    const std::shared_ptr<const Loaded> held = file != files_.end() ? file->second : nullptr;
    finding_[key] = opennessWorker_.ask(
        [view, held](const Worker::Control& control) {
            return std::make_shared<const Found>(Found{
                view.vertices.data(), keptOpenness(view, opennessFolder(), &control.progress())});
        },
        [this, key](const Result<std::shared_ptr<const Found>>& answer) {
            finding_.erase(key);
            std::shared_ptr<const Found>& found = found_[key];
            if (found) {
                outdatedOpenness_.push_back(found);
            }
            found = answer ? *answer : std::make_shared<const Found>();
            Q_EMIT opennessFound();
        },
        {}, fileName(key));
}

PickMesh MeshLibrary::pickMesh(const Object& object) {
    const auto found = files_.find(meshKey(object));
    return found == files_.end() ? PickMesh(view(object))
                                 : PickMesh(found->second->view, found->second->runs);
}

bool MeshLibrary::has(const Object& object) const {
    const MeshKey key = meshKey(object);
    return files_.contains(key) || builtins_.contains(key);
}

void MeshLibrary::readApart(const Object& object) {
    MeshKey key = meshKey(object);
    key.part = "*";
    if (!materials_.contains(key)) {
        if (!loading_.contains(key)) {
            load(key);
        }
        return;
    }
    tellAfterwards(*this, [this, mesh = key.mesh] { Q_EMIT loaded(QString::fromStdString(mesh)); });
}

std::vector<MeshMaterial> MeshLibrary::materialsOf(const Object& object) const {
    MeshKey key = meshKey(object);
    key.part = "*";
    const auto found = materials_.find(key);
    return found == materials_.end() ? std::vector<MeshMaterial>() : found->second;
}

void MeshLibrary::warmUp() {
    client().warmUp();
}

void MeshLibrary::cancelAllBut(const Scene& scene) {
    for (const auto& [key, progress] : loading_) {
        const auto isOfKey = [&wanted = key](const Object& object) {
            return readingOf(meshKey(object)) == wanted;
        };
        if (std::ranges::none_of(scene.objects, isOfKey)) {
            progress->cancelled = true;
        }
    }
}

void MeshLibrary::setRights(const FileRights& rights) {
    if (rights == rights_) {
        return;
    }
    rights_ = rights;
    ++rightsChanges_;
    client().setRights(rights);
    forgetFailures();
    for (const auto& [key, places] : std::exchange(missingLinks_, {})) {
        load(key);
    }
}

void MeshLibrary::repeatMissingLinks(const Scene& scene) {
    for (const auto& [key, places] : missingLinks_) {
        const auto isOfKey = [&wanted = key](const Object& object) {
            return readingOf(meshKey(object)) == wanted;
        };
        if (std::ranges::any_of(scene.objects, isOfKey)) {
            Q_EMIT linksRefused(QString::fromStdString(key.mesh), places);
        }
    }
}

void MeshLibrary::forgetFailures() {
    failures_.clear();
}

void MeshLibrary::readAgain(const Scene& scene) {
    forgetFailures();
    for (const Object& object : scene.objects) {
        const MeshKey key = readingOf(meshKey(object));
        if (!key.mesh.empty() && !builtinName(key.mesh) && !loading_.contains(key)) {
            load(key);
        }
    }
}

void MeshLibrary::makeBuiltin(const MeshKey& key) {
    Mesh& mesh = builtins_[key];
    Object object;
    object.mesh = key.mesh;
    object.fitUnitBox = key.fitUnitBox;
    object.flipNormals = key.flipNormals;
    Result<Mesh> made = builtinMesh(object);
    if (!made) {
        tellAfterwards(*this, [this, mesh = key.mesh, why = made.error()] {
            Q_EMIT failed(QString::fromStdString(mesh), why);
        });
        return;
    }
    mesh = std::move(*made);
}

void MeshLibrary::load(const MeshKey& key) {
    loading_[key] = worker_.ask(
        [key, &client = client()](const Worker::Control& control) {
            return read(client, key, control.progress());
        },
        [this, key, begun = rightsChanges_](const Answer& answer) {
            // What could not be read before the rights changed may be read now.
            const bool isOutdated = begun != rightsChanges_ && !loading_.at(key)->cancelled;
            loading_.erase(key);
            !answer && isOutdated ? load(key) : finish(key, answer);
        },
        {}, fileName(key));
}

/// Runs in the worker's thread.
MeshLibrary::Answer MeshLibrary::read(AssetClient& client, const MeshKey& key, Progress& progress) {
    const MeshRequest request{key.mesh, key.fitUnitBox, key.flipNormals, 1.0, !key.part.empty()};
    return client.loadMesh(request, &progress)
        .map([](const std::shared_ptr<const SharedMesh>& mesh) {
            std::vector<std::shared_ptr<const Loaded>> parts;
            for (const MeshPartView& part : mesh->parts()) {
                parts.push_back(std::make_shared<const Loaded>(
                    Loaded{mesh, part.view, runBoundsOf(part.view)}));
            }
            return parts;
        });
}

void MeshLibrary::finish(const MeshKey& key, const Answer& answer) {
    const QString file = QString::fromStdString(key.mesh);
    const std::vector<std::string> refused = client().refusedLinks(key.mesh);
    if (answer) {
        keepParts(key, answer);
        Q_EMIT loaded(file);
        if (const std::string& remarks = answer->front()->mesh->remarks(); !remarks.empty()) {
            Q_EMIT remarked({key.mesh, 0, 0, remarks, {}});
        }
    } else {
        failures_[key] = answer.error();
        Q_EMIT failed(file, answer.error());
    }
    if (!refused.empty()) {
        if (answer) {
            missingLinks_[key] = refused;
        }
        Q_EMIT linksRefused(file, refused);
    }
}

/// Keeps what was read for this key, which is a readingOf().
void MeshLibrary::keepParts(const MeshKey& reading, const Answer& answer) {
    if (reading.part.empty()) {
        keep(reading, answer->front());
        return;
    }
    std::vector<MeshMaterial>& materials = materials_[reading];
    materials.clear();
    MeshKey key = reading;
    const std::vector<MeshPartView>& parts = answer->front()->mesh->parts();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        materials.push_back(parts[i].material);
        key.part = parts[i].material.name;
        keep(key, (*answer)[i]);
    }
    if (key.part.clear(); parts.size() == 1 && !files_.contains(key)) {
        keep(key, answer->front()); // it is the whole, too
    }
}

void MeshLibrary::keep(const MeshKey& key, const std::shared_ptr<const Loaded>& mesh) {
    std::shared_ptr<const Loaded>& held = files_[key];
    if (held) {
        outdated_.push_back(held);
    }
    held = mesh;
}

AssetClient& MeshLibrary::client() {
    if (!client_) {
        client_ = std::make_unique<AssetClient>();
    }
    return *client_;
}

} // namespace patina
