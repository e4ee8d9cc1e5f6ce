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

/// Holds every mesh of the editor. Built-in ones are made when they are first asked for. A worker
/// thread has files read by the files process, and views draw without a mesh until it is loaded.
/// Another thread finds how open each vertex is, for scenes that ask for it.
class MeshLibrary : public QObject {
    Q_OBJECT

  public:
    explicit MeshLibrary(QObject* parent = nullptr);

    /// Returns the triangles of an object's mesh; empty while they are not loaded. Starts loading a
    /// file that was not asked for yet.
    MeshView view(const Object& object);

    /// Sets whether view() also starts to find how open a mesh's vertices are, where that is not
    /// known. False cancels what is being found.
    void wantOpenness(bool wanted);

    /// Reads a file's triangles apart by their materials, as the object has its mesh read. loaded()
    /// is emitted when they are there, also where they were before.
    void readApart(const Object& object);

    /// Returns the materials of such a mesh, in the order in which the file first uses them; empty
    /// where it is not read.
    std::vector<MeshMaterial> materialsOf(const Object& object) const;

    /// Returns the triangles with boxes, so that a ray need not test each triangle of a large mesh.
    PickMesh pickMesh(const Object& object);

    /// Returns whether a file is being read, or openness is being found.
    bool isLoading() const { return !loading_.empty() || !finding_.empty(); }
    bool has(const Object& object) const;

    /// Starts the files process before its first use.
    void warmUp();

    /// Cancels loading of meshes that no object of the scene has.
    void cancelAllBut(const Scene& scene);

    /// Returns the files process, for others who have files to read.
    AssetClient& client();

    /// Sets what may be read from now on. Files that failed are tried again, and meshes with
    /// missing links are read again.
    void setRights(const FileRights& rights);

    /// Emits linksRefused() again for the meshes of a scene that have missing links.
    void repeatMissingLinks(const Scene& scene);

    /// Forgets failures, so that the next view() tries again.
    void forgetFailures();

    /// Reads the files of a scene's meshes again; views show what they have until then.
    void readAgain(const Scene& scene);

  Q_SIGNALS:
    void loaded(QString file); ///< is emitted when its triangles are there
    void opennessFound();      ///< is emitted when view() has it, or finding it was cancelled
    void remarked(patina::Error remark);          ///< says what was left out of a mesh
    void failed(QString file, patina::Error why); ///< is also emitted when it was cancelled
    /// Is emitted when the file was read, or could not be, without these files that it links to.
    void linksRefused(QString file, std::vector<std::string> places);

  private:
    /// Holds a mesh of a file, and the boxes for picking in it.
    struct Loaded {
        std::shared_ptr<const SharedMesh> mesh;
        MeshView view; ///< is that of the mesh or of one of its parts
        std::vector<Bounds> runs;
    };
    using Answer = Result<std::vector<std::shared_ptr<const Loaded>>>;

    /// Holds how open each vertex of a mesh is, that is how much the mesh hides from itself.
    struct Found {
        const Vertex* vertices = nullptr;     ///< identify the mesh
        std::vector<VertexOpenness> openness; ///< is empty if it was cancelled
    };

    MeshView triangles(const MeshKey& key);
    void addOpenness(MeshView& view, const MeshKey& key);
    void findOpenness(const MeshView& view, const MeshKey& key);
    void keep(const MeshKey& key, const std::shared_ptr<const Loaded>& mesh);
    void keepParts(const MeshKey& reading, const Answer& answer);
    static Answer read(AssetClient& client, const MeshKey& key, Progress& progress);
    void makeBuiltin(const MeshKey& key);
    void load(const MeshKey& key);
    void finish(const MeshKey& key, const Answer& answer);

    std::unique_ptr<AssetClient> client_;
    std::map<MeshKey, Mesh> builtins_;
    std::map<MeshKey, std::shared_ptr<const Loaded>> files_;
    /// Holds the materials of meshes that were read apart, by their readingOf().
    std::map<MeshKey, std::vector<MeshMaterial>> materials_;
    /// Holds those of meshes in files_, by their readingOf(), as loading_ and failures_ do.
    std::map<MeshKey, std::vector<std::string>> missingLinks_;
    /// Holds replaced meshes until the library goes, since frames may still draw them.
    std::vector<std::shared_ptr<const Loaded>> outdated_;
    std::map<MeshKey, std::shared_ptr<Progress>> loading_;
    std::map<MeshKey, Error> failures_;
    std::map<MeshKey, std::shared_ptr<const Found>> found_;
    /// Holds replaced openness until the library goes, since frames may still draw it.
    std::vector<std::shared_ptr<const Found>> outdatedOpenness_;
    std::map<MeshKey, std::shared_ptr<Progress>> finding_;
    FileRights rights_;
    int rightsChanges_ = 0; ///< counts how often they changed
    bool wantsOpenness_ = false;
    Worker opennessWorker_;
    Worker worker_;
};

} // namespace patina
