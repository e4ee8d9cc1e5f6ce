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
/// What meshes hide from themselves is found in another thread, for scenes that ask for it.
class MeshLibrary : public QObject {
    Q_OBJECT

  public:
    explicit MeshLibrary(QObject* parent = nullptr);

    /// The triangles of an object's mesh, or an empty view while they are not there. A file that
    /// was not asked for yet starts loading.
    MeshView view(const Object& object);

    /// Tells whether view() has what a mesh hides from itself found where that is not there yet.
    /// What is being found for nobody any more is given up.
    void wantOpenness(bool wanted);

    /// The same for rays, which need not look at each triangle of a large mesh.
    PickMesh pickMesh(const Object& object);

    /// Tells whether a file is read, or what a mesh hides is found.
    bool isLoading() const { return !loading_.empty() || !finding_.empty(); }
    bool has(const Object& object) const;

    /// Starts the files process ahead of its first use.
    void warmUp();

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
    void loaded(QString file);           ///< its triangles are there
    void opennessFound();                ///< view() has it, or does without it
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

    /// Holds what a mesh hides from itself.
    struct Found {
        const Vertex* vertices = nullptr;     ///< whose it is
        std::vector<VertexOpenness> openness; ///< empty: it was cancelled
    };

    MeshView triangles(const MeshKey& key);
    void addOpenness(MeshView& view, const MeshKey& key);
    void findOpenness(const MeshView& view, const MeshKey& key);
    static Answer read(AssetClient& client, const MeshKey& key, Progress& progress);
    void makeBuiltin(const MeshKey& key);
    void load(const MeshKey& key);
    void finish(const MeshKey& key, const Answer& answer);

    std::unique_ptr<AssetClient> client_;
    std::map<MeshKey, Mesh> builtins_;
    std::map<MeshKey, std::shared_ptr<const Loaded>> files_;
    std::map<MeshKey, std::vector<std::string>> missingLinks_; ///< of the files
    std::vector<std::shared_ptr<const Loaded>> outdated_;      ///< frames may still draw them
    std::map<MeshKey, std::shared_ptr<Progress>> loading_;
    std::map<MeshKey, Error> failures_;
    std::map<MeshKey, std::shared_ptr<const Found>> found_;
    std::vector<std::shared_ptr<const Found>> outdatedOpenness_; ///< frames may still draw it
    std::map<MeshKey, std::shared_ptr<Progress>> finding_;
    FileRights rights_;
    bool wantsOpenness_ = false;
    Worker opennessWorker_;
    Worker worker_;
};

} // namespace patina
