// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "assets/asset_client.h"
#include "catalog/catalog.h"
#include "core/error.h"
#include "core/mesh.h"
#include "scene/mesh_key.h"
#include "scene/scene.h"

namespace patina {

/// Holds all meshes of a scene, read before the first frame.
class SceneMeshes {
  public:
    /// Reads every mesh the visible objects name; all that cannot be had are in the error.
    static Checked<SceneMeshes> load(const Scene& scene, const Catalog& catalog,
                                     AssetClient& client);

    MeshView view(const Object& object) const;

    /// Returns warnings: what was left out of the meshes that were read, which meshes with images
    /// have no texture coordinates, and which have no vertex colours that a material asks for.
    Errors remarks() const;

  private:
    void findOpenness();
    Result<void> add(const Object& object, AssetClient& client);
    void nameMissing(const Scene& scene);
    void note(const Object& object, const char* missing);

    Errors missing_; ///< are warnings of what images or vertex colours need and meshes do not have
    Errors remarks_; ///< warnings of the meshes that were read
    std::map<MeshKey, Mesh> made_;
    std::vector<std::shared_ptr<const SharedMesh>> read_;
    /// Refers to the whole of meshes, and to the parts of those that are shown in parts.
    std::map<MeshKey, MeshView> views_;
    /// Is filled where the scene asks for it.
    std::map<MeshKey, std::vector<VertexOpenness>> openness_;
};

} // namespace patina
