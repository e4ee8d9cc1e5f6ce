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
        return found->second->mesh->view();
    }
    if (!key.mesh.empty() && !loading_.contains(key) && !failures_.contains(key)) {
        load(key);
    }
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
                                 : PickMesh(found->second->mesh->view(), found->second->runs);
}

bool MeshLibrary::has(const Object& object) const {
    const MeshKey key = meshKey(object);
    return files_.contains(key) || builtins_.contains(key);
}

void MeshLibrary::warmUp() {
    client().warmUp();
}

void MeshLibrary::cancelAllBut(const Scene& scene) {
    for (const auto& [key, progress] : loading_) {
        const auto isOfKey = [&wanted = key](const Object& object) {
            return meshKey(object) == wanted;
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
    client().setRights(rights);
    forgetFailures();
    for (const auto& [key, places] : std::exchange(missingLinks_, {})) {
        load(key);
    }
}

void MeshLibrary::repeatMissingLinks(const Scene& scene) {
    for (const auto& [key, places] : missingLinks_) {
        const auto isOfKey = [&wanted = key](const Object& object) {
            return meshKey(object) == wanted;
        };
        if (std::ranges::any_of(scene.objects, isOfKey)) {
            Q_EMIT linksRefused(QString::fromStdString(key.mesh), places);
        }
    }
}

void MeshLibrary::forgetFailures() {
    failures_.clear();
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
        [this, key](const Answer& answer) { finish(key, answer); }, {}, fileName(key));
}

/// Runs in the worker's thread.
MeshLibrary::Answer MeshLibrary::read(AssetClient& client, const MeshKey& key, Progress& progress) {
    const MeshRequest request{key.mesh, key.fitUnitBox, key.flipNormals, 1.0};
    return client.loadMesh(request, &progress).map([](std::shared_ptr<const SharedMesh> mesh) {
        std::vector<Bounds> runs = runBoundsOf(mesh->view());
        return std::make_shared<const Loaded>(Loaded{std::move(mesh), std::move(runs)});
    });
}

void MeshLibrary::finish(const MeshKey& key, const Answer& answer) {
    loading_.erase(key);
    const QString file = QString::fromStdString(key.mesh);
    const std::vector<std::string> refused = client().refusedLinks(key.mesh);
    if (answer) {
        std::shared_ptr<const Loaded>& held = files_[key];
        if (held) {
            outdated_.push_back(held);
        }
        held = *answer;
        Q_EMIT loaded(file);
        if (const std::string& remarks = (*answer)->mesh->remarks(); !remarks.empty()) {
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

AssetClient& MeshLibrary::client() {
    if (!client_) {
        client_ = std::make_unique<AssetClient>();
    }
    return *client_;
}

} // namespace patina
