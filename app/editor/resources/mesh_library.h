// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "core/error.h"
#include "resources/pick_mesh.h"
#include "scene/mesh_key.h"
#include "scene/scene.h"

namespace patina {

/// Every mesh the editor has. Built-in ones are made when they are first asked for; files are read
/// by the files process, asked from a worker thread, and the views draw without them until then.
class MeshLibrary : public QObject {
    Q_OBJECT

  public:
    explicit MeshLibrary(QObject* parent = nullptr);

    /// The triangles of an object's mesh, or an empty view while they are not there. A file that
    /// was not asked for yet starts loading.
    MeshView view(const Object& object);

    /// The same for rays, which need not look at each triangle of a large mesh.
    PickMesh pickMesh(const Object& object);

    bool isLoading() const { return !loading_.empty(); }
    bool has(const Object& object) const;

    /// Starts the files process ahead of its first use.
    void warmUp();

    /// Gives up on everything that is loading.
    void cancelAll() { worker_.cancel(); }

    /// Gives up on what is loading and is in no object of the scene.
    void cancelAllBut(const Scene& scene);

    /// The files process, for whoever else has files to read.
    AssetClient& client();

    /// Sets what is read from now on; what failed with other rights is tried again, and what lacks
    /// links is read again.
    void setRights(const FileRights& rights);

    /// Says again which links the meshes of a scene lack.
    void repeatMissingLinks(const Scene& scene);

    /// Forgets failures, so that the next view() tries again.
    void forgetFailures();

  Q_SIGNALS:
    void loadingStarted(QString file);
    void progressed(QString file, float share);
    void loaded(QString file);           ///< its triangles are there
    void remarked(patina::Error remark); ///< what had to be left out of a mesh that is there
    void failed(QString file, patina::Error why); ///< also when it was cancelled
    /// The file was read, or could not be, without these.
    void linksRefused(QString file, std::vector<std::string> places);

  private:
    /// Holds what a file gave, and what picking in it needs.
    struct Loaded {
        std::shared_ptr<const SharedMesh> mesh;
        std::vector<Bounds> runs;
    };
    using Answer = Result<std::shared_ptr<const Loaded>>;

    static Answer read(AssetClient& client, const MeshKey& key, Progress& progress);
    void makeBuiltin(const MeshKey& key);
    void load(const MeshKey& key);
    void finish(const MeshKey& key, const Answer& answer);
    void reportProgress();

    std::unique_ptr<AssetClient> client_;
    std::map<MeshKey, Mesh> builtins_;
    std::map<MeshKey, std::shared_ptr<const Loaded>> files_;
    std::map<MeshKey, std::vector<std::string>> missingLinks_; ///< of the files
    std::vector<std::shared_ptr<const Loaded>> outdated_;      ///< frames may still draw them
    std::map<MeshKey, std::shared_ptr<Progress>> loading_;
    std::map<MeshKey, Error> failures_;
    FileRights rights_;
    Worker worker_;
};

} // namespace patina
