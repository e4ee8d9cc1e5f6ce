// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_meshes.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "cli/picture_options.h"
#include "core/image_places.h"
#include "scene/builtin_mesh.h"
#include "scene/kept_openness.h"
#include "scene/mesh_path.h"
#include "shading/effects/occlusion.h"

namespace patina {

Checked<SceneMeshes> SceneMeshes::load(const Scene& scene, const Catalog& catalog,
                                       AssetClient& client) {
    SceneMeshes meshes;
    Errors errors;
    std::set<MeshKey> refused;
    for (const Object& object : scene.objects) {
        if (!object.visible || !meshes.view(object).indices.empty() ||
            refused.contains(meshKey(object))) {
            continue;
        }
        if (auto added = meshes.add(object, client); !added) {
            errors.push_back(added.error());
            refused.insert(meshKey(object));
        }
    }
    if (!errors.empty()) {
        return tl::unexpected(errors);
    }
    meshes.nameMissing(scene);
    if (needsOpenness(scene, catalog)) {
        meshes.findOpenness();
    }
    return meshes;
}

void SceneMeshes::findOpenness() {
    for (const auto& [key, mesh] : made_) {
        openness_.emplace(key, keptOpenness(mesh.view(), opennessFolder()));
    }
    for (const auto& [key, view] : views_) {
        openness_.emplace(key, keptOpenness(view, opennessFolder()));
    }
}

void SceneMeshes::nameMissing(const Scene& scene) {
    for (const Object& object : scene.objects) {
        bool hasImages = false;
        bool hasColors = false;
        for (const auto& [key, use] : object.material.textures) {
            const bool counts =
                object.visible && use.enabled && !use.file.empty() && use.strength != 0.0;
            hasColors = hasColors || (counts && isVertexColors(use.file));
            hasImages = hasImages || (counts && !isVertexColors(use.file));
        }
        if (hasImages && !hasImagePlaces(view(object).vertices)) {
            note(object, "the mesh has no texture coordinates: an image is the same all over it");
        }
        if (hasColors && view(object).colors.empty()) {
            note(object, "the mesh has no vertex colours: they count as white");
        }
    }
}

/// Notes what is missing in the mesh of an object, once.
void SceneMeshes::note(const Object& object, const char* missing) {
    const Error remark{object.mesh, 0, 0, missing, {}};
    if (std::ranges::find(missing_, remark) == missing_.end()) {
        missing_.push_back(remark);
    }
}

Result<void> SceneMeshes::add(const Object& object, AssetClient& client) {
    if (builtinName(object.mesh)) {
        auto mesh = builtinMesh(object);
        if (!mesh) {
            return tl::unexpected(mesh.error());
        }
        made_.emplace(meshKey(object), std::move(*mesh));
        return {};
    }
    const bool byMaterial = !object.part.empty();
    auto mesh =
        client.loadMesh({object.mesh, object.fitUnitBox, object.flipNormals, 1.0, byMaterial});
    const bool hasRefusedLinks = !client.refusedLinks(object.mesh).empty();
    if (!mesh) {
        Error error = mesh.error();
        if (hasRefusedLinks) {
            error.expected +=
                fmt::format("{}{}", error.expected.empty() ? "" : ", or ", allowOutsideHint);
        }
        return tl::unexpected(error);
    }
    if (const std::string& remarks = (*mesh)->remarks(); !remarks.empty()) {
        remarks_.push_back({object.mesh, 0, 0, remarks, hasRefusedLinks ? allowOutsideHint : ""});
    }
    MeshKey key = meshKey(object);
    for (const MeshPartView& part : (*mesh)->parts()) {
        key.part = byMaterial ? part.material.name : std::string();
        views_.emplace(key, part.view);
    }
    const bool isThere = views_.contains(meshKey(object));
    read_.push_back(std::move(*mesh));
    return isThere ? Result<void>() : tl::unexpected(missingPart(object.mesh, object.part));
}

Errors SceneMeshes::remarks() const {
    Errors remarks = missing_;
    remarks.insert(remarks.end(), remarks_.begin(), remarks_.end());
    return remarks;
}

MeshView SceneMeshes::view(const Object& object) const {
    const MeshKey key = meshKey(object);
    MeshView view;
    if (const auto made = made_.find(key); made != made_.end()) {
        view = made->second.view();
    } else if (const auto read = views_.find(key); read != views_.end()) {
        view = read->second;
    }
    if (const auto openness = openness_.find(key); openness != openness_.end()) {
        view.openness = openness->second;
    }
    return view;
}

} // namespace patina
