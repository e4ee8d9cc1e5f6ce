// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/scene_depth.h"

#include <memory>

#include "render/lights/fog_reach.h"
#include "render/lights/frustum.h"
#include "render/lights/ground_place.h"
#include "render/lights/light_lists.h"
#include "shading/effects/opacity.h"

namespace patina {
namespace {

/// Returns the number of an object's list. The objects before it get theirs first, as in a frame,
/// because lists can be used up.
std::size_t listFor(std::size_t object, LightLists& lists, const Scene& scene,
                    const MeshSource& meshes) {
    std::size_t list = 0;
    for (std::size_t i = 0; i <= object; ++i) {
        const Object& each = scene.objects[i];
        const MeshView mesh = i == object || isDrawn(each) ? meshes(each) : MeshView();
        if (!mesh.indices.empty()) {
            list = lists.listFor(ballAround(mesh.bounds, worldMatrix(each)));
        }
    }
    return list;
}

} // namespace

EffectView effectView(const Scene& scene, const Camera& camera, const Catalog& catalog,
                      const MeshSource& meshes) {
    const glm::dmat4 worldToCamera = viewMatrix(camera);
    DepthRange depths;
    GroundUnder under;
    FogReach fog(scene, catalog, eye(camera));
    for (const Object& object : scene.objects) {
        if (!isDrawn(object)) {
            continue;
        }
        const MeshView mesh = meshes(object);
        const glm::dmat4 world = worldMatrix(object);
        depths.add(mesh.bounds, worldToCamera * world);
        fog.add(mesh.bounds, world);
        if (isSeen(scene.ground) && !mesh.indices.empty()) {
            under.add(mesh.bounds, world, lowestPoint(mesh, world));
        }
    }
    if (const auto place = under.place(scene.ground, eye(camera))) {
        addGround(depths, *place, camera);
        fog.add(groundBounds(), worldMatrix(*place));
    }
    return effectView(depths, fog);
}

EffectView objectView(const Scene& scene, std::size_t object, const Catalog& catalog,
                      const MeshSource& meshes) {
    EffectView view = effectView(scene, scene.camera, catalog, meshes);
    LightLists lists;
    lists.begin(scene, catalog);
    if (!lists.isOne() && !meshes(scene.objects[object]).indices.empty()) {
        view.unreached = std::make_shared<const LightSet>(
            lists.unreached(listFor(object, lists, scene, meshes)));
    }
    return view;
}

} // namespace patina
