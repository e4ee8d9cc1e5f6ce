// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QThreadPool>

#include "assets/asset_client.h"
#include "core/error.h"
#include "scene/scene.h"
#include "viewport/pick_mesh.h"

namespace patina {

/// Every mesh the editor has. Built-in ones are made when they are first asked for; files are read
/// by the files process, asked from a worker thread, and the views draw without them until then.
class MeshLibrary : public QObject {
    Q_OBJECT

  public:
    explicit MeshLibrary(QObject* parent = nullptr);
    ~MeshLibrary() override;

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
    void cancelAll();

    /// Gives up on what is loading and is in no object of the scene.
    void cancelAllBut(const Scene& scene);

    /// The files process, for whoever else has files to read.
    AssetClient& client();

    /// Forgets failures, so that the next view() tries again.
    void forgetFailures();

  Q_SIGNALS:
    void loadingStarted(QString file);
    void progressed(QString file, float share);
    void loaded(QString file);                  ///< its triangles are there
    void remarked(patina::Error remark);        ///< what had to be left out of a mesh that is there
    void failed(QString file, patina::Error why); ///< also when it was cancelled

  private:
    /// What makes one mesh differ from another.
    struct Key {
        std::string mesh;
        bool fitUnitBox = false;
        bool flipNormals = false;

        friend auto operator<=>(const Key&, const Key&) = default;
    };
    /// What a file gave, and what picking in it needs.
    struct Loaded {
        std::shared_ptr<const SharedMesh> mesh;
        std::vector<Bounds> runs;
    };
    using Answer = Result<std::shared_ptr<const Loaded>>;

    static Key keyOf(const Object& object);
    static Answer read(AssetClient& client, const Key& key, Progress& progress);
    void makeBuiltin(const Key& key);
    void load(const Key& key);
    void finish(const Key& key, const Answer& answer);
    void reportProgress();

    std::unique_ptr<AssetClient> client_;
    std::map<Key, Mesh> builtins_;
    std::map<Key, std::shared_ptr<const Loaded>> files_;
    std::map<Key, std::shared_ptr<Progress>> loading_;
    std::map<Key, Error> failures_;
    QThreadPool worker_;
};

} // namespace patina
