// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/builtin_mesh.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "scene/mesh_path.h"
#include "scene/primitives.h"

namespace patina {

namespace {

void flip(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices) {
        vertex.normal = -vertex.normal;
        vertex.tangent.w = -vertex.tangent.w;
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

void fitUnitBox(Mesh& mesh) {
    const glm::vec3 size = mesh.bounds.size();
    const float longest = std::max({size.x, size.y, size.z});
    const glm::vec3 middle = mesh.bounds.center();
    for (Vertex& vertex : mesh.vertices) {
        vertex.position = (vertex.position - middle) * (2.0f / longest);
    }
    mesh.bounds = boundsOf(mesh.vertices);
}

Error unknownName(std::string_view name) {
    std::string known;
    for (const std::string& each : primitiveNames()) {
        known += (known.empty() ? "one of " : ", ") + each;
    }
    return failure(fmt::format("there is no built-in mesh \"{}\"", name), known).value();
}

} // namespace

Result<Mesh> builtinMesh(const Object& object) {
    const std::string_view name = builtinName(object.mesh).value_or(object.mesh);
    std::optional<Mesh> mesh = primitive(name);
    if (!mesh) {
        return tl::unexpected(unknownName(name));
    }
    if (object.fitUnitBox) {
        fitUnitBox(*mesh);
    }
    if (object.flipNormals) {
        flip(*mesh);
    }
    return std::move(*mesh);
}

} // namespace patina
