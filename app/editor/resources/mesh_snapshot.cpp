// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/mesh_snapshot.h"

#include <map>
#include <utility>

#include "resources/mesh_library.h"
#include "scene/mesh_key.h"

namespace patina {
MeshSource meshSnapshot(const Scene& scene, MeshLibrary& library) {
    std::map<MeshKey, MeshView> views;
    for (const Object& object : scene.objects) {
        views.try_emplace(meshKey(object), library.view(object));
    }
    return [views = std::move(views)](const Object& object) {
        const auto found = views.find(meshKey(object));
        return found == views.end() ? MeshView() : found->second;
    };
}

} // namespace patina
