// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/mesh_snapshot.h"

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "viewport/mesh_library.h"

namespace patina {
namespace {

using MeshKey = std::tuple<std::string, bool, bool>;

MeshKey keyOf(const Object& object) {
    return {object.mesh, object.fitUnitBox, object.flipNormals};
}

} // namespace

MeshSource meshSnapshot(const Scene& scene, MeshLibrary& library) {
    std::map<MeshKey, MeshView> views;
    for (const Object& object : scene.objects) {
        views.try_emplace(keyOf(object), library.view(object));
    }
    return [views = std::move(views)](const Object& object) {
        const auto found = views.find(keyOf(object));
        return found == views.end() ? MeshView() : found->second;
    };
}

} // namespace patina
