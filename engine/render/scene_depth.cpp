// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_depth.h"

#include "render/fog_reach.h"
#include "render/frustum.h"
#include "render/ground_place.h"
#include "render/light_lists.h"
#include "shading/texture_choice.h"

namespace patina {

EffectView effectView(const Scene& scene, const Camera& camera, const Catalog& catalog,
                      const MeshSource& meshes) {
    const glm::dmat4 worldToCamera = viewMatrix(camera);
    DepthRange depths;
    GroundUnder under;
    FogReach fog(scene, catalog, eye(camera));
    for (const Object& object : scene.objects) {
        if (!object.visible || !canBeSeen(object.material)) {
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
    const MeshView mesh = meshes(scene.objects[object]);
    if (!mesh.indices.empty()) {
        LightLists lists;
        lists.begin(scene, catalog);
        view.unreached = lists.unreached(
            lists.listFor(ballAround(mesh.bounds, worldMatrix(scene.objects[object]))));
    }
    return view;
}

} // namespace patina
