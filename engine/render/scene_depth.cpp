// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_depth.h"

#include "render/frustum.h"
#include "render/ground_place.h"
#include "shading/texture_choice.h"

namespace patina {

EffectView effectView(const Scene& scene, const Camera& camera, const MeshSource& meshes) {
    const glm::dmat4 worldToCamera = viewMatrix(camera);
    DepthRange depths;
    GroundUnder under;
    for (const Object& object : scene.objects) {
        if (!object.visible || !canBeSeen(object.material)) {
            continue;
        }
        const MeshView mesh = meshes(object);
        const glm::dmat4 world = worldMatrix(object);
        depths.add(mesh.bounds, worldToCamera * world);
        if (isSeen(scene.ground) && !mesh.indices.empty()) {
            under.add(mesh.bounds, world, lowestPoint(mesh, world));
        }
    }
    if (const auto place = under.place(scene.ground, eye(camera))) {
        addGround(depths, *place, camera);
    }
    return effectView(depths);
}

} // namespace patina
