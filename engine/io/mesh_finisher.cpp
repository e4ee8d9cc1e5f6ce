// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_finisher.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "core/vectors.h"
#include "io/mesh_parts.h"
#include "io/normals.h"
#include "io/tangents.h"
#include "io/triangle_filter.h"
#include "io/vertex_joiner.h"

namespace patina {
namespace {

/// Returns the error for a mesh without a single triangle, which says what the mesh holds instead.
Error nothingToDraw(const RawMesh& mesh, const UselessTriangles& dropped) {
    Error error;
    if (dropped.all() > 0) {
        error.problem = fmt::format("none of its {} triangles can be drawn: they have {}",
                                    dropped.all(), dropped.reasons());
    } else if (mesh.pointsAndLines > 0) {
        error.problem = "has points or lines but no faces";
    } else {
        error.problem = "has no vertices and no faces";
    }
    error.expected = "a surface made of triangles or polygons";
    return error;
}

std::string remarksOn(const UselessTriangles& dropped, std::size_t triangles) {
    if (dropped.all() == 0) {
        return {};
    }
    return fmt::format("{} of {} triangles had {} and were left out", dropped.all(),
                       dropped.all() + triangles, dropped.reasons());
}

/// Scales the mesh uniformly about the centre, so that normals and tangents stay as they are.
Result<void> scale(RawMesh& mesh, const MeshOptions& options) {
    if (!(options.scale > 0.0) || !std::isfinite(options.scale)) {
        return failure("the scale is not usable", "a number above 0");
    }
    Bounds bounds;
    std::ranges::for_each(mesh.positions, [&](const glm::vec3& p) { bounds.add(p); });
    const glm::dvec3 lower(bounds.lower);
    const glm::dvec3 upper(bounds.upper);
    const glm::dvec3 size = upper - lower;
    const double longest = std::max({size.x, size.y, size.z});
    const glm::dvec3 center = options.fitUnitBox ? 0.5 * (lower + upper) : glm::dvec3(0.0);
    const double factor = options.scale * (options.fitUnitBox ? 2.0 / longest : 1.0);
    if (factor == 1.0 && center == glm::dvec3(0.0)) {
        return {};
    }
    for (glm::vec3& p : mesh.positions) {
        p = glm::vec3(factor * (glm::dvec3(p) - center));
    }
    const bool kept =
        std::ranges::all_of(mesh.positions, [](const glm::vec3& p) { return isFinite(p); });
    return kept ? Result<void>() : failure("the scale makes the mesh too large", "a smaller one");
}

void flip(RawMesh& mesh) {
    for (glm::vec3& n : mesh.normals) {
        n = -n;
    }
    for (glm::vec4& t : mesh.tangents) {
        t.w = -t.w;
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

glm::vec2 finiteUv(const RawMesh& mesh, std::size_t i) {
    if (mesh.uvs.empty() || !std::isfinite(mesh.uvs[i].x) || !std::isfinite(mesh.uvs[i].y)) {
        return glm::vec2(0.0f);
    }
    return mesh.uvs[i];
}

/// Returns a share in steps of 1 / 65535; white where it is no number.
std::uint16_t inSteps(float share) {
    constexpr float steps = 65535.0f;
    return static_cast<std::uint16_t>(std::isfinite(share)
                                          ? std::lround(steps * std::clamp(share, 0.0f, 1.0f))
                                          : std::lround(steps));
}

VertexColor packed(const glm::vec4& color) {
    const auto missing = [](float share) { return std::uint16_t(65535 - inSteps(share)); };
    return {missing(color.x), missing(color.y), missing(color.z), inSteps(color.w)};
}

bool hasColors(const RawMesh& mesh) {
    return std::ranges::any_of(
        mesh.colors, [](const glm::vec4& color) { return packed(color) != VertexColor(); });
}

/// Takes vertex colours from the material of a mesh that has none, since all of its file's may have
/// been given them.
void dropUnusedColors(MeshPart& part) {
    if (!part.hasColors) {
        std::erase_if(part.material.images,
                      [](const auto& image) { return isVertexColors(image.second); });
    }
}

/// Orders triangles for the vertex cache and vertices for fetching, and writes both into the
/// target.
void write(const RawMesh& mesh, const MeshSpans& target) {
    const std::size_t vertices = mesh.positions.size();
    meshopt_optimizeVertexCacheFifo(target.indices.data(), mesh.indices.data(), mesh.indices.size(),
                                    vertices, 16);
    std::vector<std::uint32_t> order(vertices);
    meshopt_optimizeVertexFetchRemap(order.data(), target.indices.data(), target.indices.size(),
                                     vertices);
    meshopt_remapIndexBuffer(target.indices.data(), target.indices.data(), target.indices.size(),
                             order.data());
    for (std::size_t i = 0; i < vertices; ++i) {
        target.vertices[order[i]] = {mesh.positions[i], mesh.normals[i], mesh.tangents[i],
                                     finiteUv(mesh, i)};
    }
    for (std::size_t i = 0; i < target.colors.size(); ++i) {
        target.colors[order[i]] = packed(mesh.colors[i]);
    }
}

Result<void> writeParts(const std::vector<RawMesh>& meshes, const MeshStorage& storage) {
    std::vector<MeshMaterial> materials;
    for (const RawMesh& mesh : meshes) {
        materials.insert(materials.end(), mesh.materials.begin(), mesh.materials.end());
    }
    std::vector<MeshPart> parts;
    for (const RawMesh& mesh : meshes) {
        const bool isNamed = !mesh.materials.empty();
        parts.push_back({isNamed ? mesh.materials.front() : nameless(materials),
                         mesh.positions.size(), mesh.indices.size(), hasColors(mesh)});
        dropUnusedColors(parts.back());
    }
    auto target = storage(parts);
    if (!target) {
        return tl::unexpected(target.error());
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const RawMesh& mesh = meshes[i];
        const std::size_t colors = parts[i].hasColors ? mesh.positions.size() : 0;
        write(mesh, {target->vertices.first(mesh.positions.size()),
                     target->indices.first(mesh.indices.size()), target->colors.first(colors)});
        target->vertices = target->vertices.subspan(mesh.positions.size());
        target->indices = target->indices.subspan(mesh.indices.size());
        target->colors = target->colors.subspan(colors);
    }
    return {};
}

} // namespace

Result<std::string> finishMesh(RawMesh mesh, const MeshOptions& options,
                               const MeshStorage& storage) {
    const UselessTriangles dropped = dropUselessTriangles(mesh);
    if (mesh.indices.empty()) {
        return tl::unexpected(nothingToDraw(mesh, dropped));
    }
    joinVertices(mesh);
    if (const auto scaled = scale(mesh, options); !scaled) {
        return tl::unexpected(scaled.error());
    }
    completeNormals(mesh);
    completeTangents(mesh);
    if (options.flipNormals) {
        flip(mesh);
    }
    std::string remarks = remarksOn(dropped, mesh.indices.size() / 3);
    if (const std::string left = mesh.leftOut.text(options.byMaterial); !left.empty()) {
        remarks += (remarks.empty() ? "" : "; ") + left;
    }
    if (!options.byMaterial) {
        mesh.materials.clear();
        mesh.materialOf.clear();
    }
    return writeParts(splitByMaterial(std::move(mesh)), storage).map([&] { return remarks; });
}

} // namespace patina
