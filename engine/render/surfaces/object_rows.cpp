// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/object_rows.h"

#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "catalog/combing_role.h"
#include "core/convex_facets.h"
#include "core/image_places.h"
#include "render/lights/frustum.h"
#include "render/lights/light_lists.h"
#include "render/lights/placement.h"
#include "render/surfaces/scene_depth.h"
#include "shading/effects/light_reach.h"
#include "shading/effects/lights.h"
#include "shading/effects/opacity.h"
#include "shading/effects/refraction.h"
#include "shading/effects/shells.h"

namespace patina {
namespace {

constexpr std::string_view textureKind = "texture/";
constexpr std::string_view environmentKind = "environment/";

/// Returns the columns of a matrix made unit and perpendicular, one after the other (Gram-Schmidt).
glm::dmat3 perpendicularAxes(const glm::dmat3& m) {
    const glm::dvec3 x = glm::normalize(m[0]);
    const glm::dvec3 z = glm::normalize(glm::cross(x, m[1]));
    return {x, glm::cross(z, x), z};
}

/// Returns the distance in metres from a point of world space to a box of object space, at most:
/// that to the upright box around it where a shear slants it.
double distanceTo(const Bounds& bounds, const glm::dmat4& world, const glm::dvec3& point) {
    const glm::dvec3 way = point - ballAround(bounds, world).center;
    const glm::dmat3 toAxes = glm::transpose(perpendicularAxes(glm::dmat3(world)));
    const glm::dmat3 edges = toAxes * glm::dmat3(world);
    const glm::dvec3 size(bounds.upper - bounds.lower);
    glm::dvec3 outside = glm::abs(toAxes * way);
    for (int i = 0; i < 3; ++i) {
        outside -= 0.5 * size[i] * glm::abs(edges[i]);
    }
    return glm::length(glm::max(outside, glm::dvec3(0.0)));
}

/// Returns a sentence on why a light is not on an object's list, which depends on the object's
/// bounding sphere.
std::string whyUnreached(const LightReach& reach, const Bounds& bounds, const glm::dmat4& world) {
    const Ball ball = ballAround(bounds, world);
    if (!(reach.range > 0.0) ||
        glm::distance(reach.from, ball.center) - ball.radius <= reach.range) {
        return "Its cone misses this object.";
    }
    return fmt::format("Its range of {:.3g} m ends before this object, which is at least {:.3g} m "
                       "away.",
                       reach.range, distanceTo(bounds, world, reach.from));
}

/// Adds a row for each light that shines and does not reach the object.
void addUnreached(std::vector<EffectRow>& rows, const Scene& scene, std::size_t object,
                  const Catalog& catalog, const EffectView& view, const MeshView& mesh) {
    const glm::dmat4 world = worldMatrix(scene.objects[object]);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = catalog.find(kinds::lights, light.block.id);
        if (block != nullptr && canShine(light, *block) && !view.reaches(i)) {
            rows.push_back({{lightName(scene, i),
                             {},
                             whyUnreached(reachOf(light, *block), mesh.bounds, world)},
                            false,
                            false,
                            {}});
        }
    }
}

/// Returns what an image does that is constant all over the object, as the end of a sentence.
const char* evenlyText(const BoundTexture& image) {
    switch (image.role) {
    case TextureRole::Normal:
        return "it leans all of the surface the same way";
    case TextureRole::Height:
        return "it has no effect";
    case TextureRole::Opacity:
        return "it is one opacity";
    default:
        return image.parameter->role == roles::combing ? "it says no direction"
               : image.isColor()                       ? "it is one colour"
                                                       : "it is one value";
    }
}

bool isMissing(const TextureUse& use, const BoundTexture& image, const KnownImages& images) {
    return images.textures && images.textures(use, decodingOf(use, image)).isMissing;
}

const char* missingText(const TextureUse& use) {
    return use.outside ? " The image's file lies outside the preset's folder and is not "
                         "read: a placeholder is shown."
                       : " The image's file is missing or cannot be read: a placeholder is shown.";
}

/// Completes the rows of images: says when a file is missing, and when the mesh has no texture
/// coordinates.
void describeImages(std::vector<EffectRow>& rows, const Material& material, const Catalog& catalog,
                    const MeshView& mesh, const KnownImages& images) {
    const bool isPlaceless = !mesh.indices.empty() && !hasImagePlaces(mesh.vertices);
    for (EffectRow& row : rows) {
        if (!row.in || !row.line.effect.starts_with(textureKind)) {
            continue;
        }
        const auto use = material.textures.find(row.line.effect.substr(textureKind.size()));
        const BoundTexture image =
            boundTexture(use->second, textureTarget(use->first, use->second, material, catalog));
        if (image.isOfVertices) {
            if (!mesh.indices.empty() && mesh.colors.empty()) {
                row.line.reason += " The mesh has no vertex colours: it counts as white.";
            }
            continue;
        }
        if (isMissing(use->second, image, images)) {
            row.line.reason += missingText(use->second);
        }
        if (isPlaceless) {
            row.line.reason +=
                fmt::format(" The mesh has no texture coordinates: {}.", evenlyText(image));
        }
    }
}

void describeEnvironment(std::vector<EffectRow>& rows, const KnownImages& images) {
    for (EffectRow& row : rows) {
        if (images.isEnvironmentMissing && row.in && row.line.effect.starts_with(environmentKind)) {
            row.line.reason = "The file of the environment's picture is missing or cannot be read: "
                              "a placeholder sends light.";
        }
    }
}

/// Says how many facets the rays are followed among, or why the mesh has none for them.
void describeFacets(std::vector<EffectRow>& rows, const Material& material, const Catalog& catalog,
                    const MeshView& mesh) {
    const Block* block = refractionChoice(material, catalog).block;
    if (block == nullptr || !followsFacets(*block) || mesh.indices.empty()) {
        return;
    }
    const ConvexFacets facets = convexFacetsOf(mesh);
    for (EffectRow& row : rows) {
        if (row.in && row.line.effect == effectName(block->kind, block->id)) {
            row.line.reason +=
                facets.planes.empty()
                    ? fmt::format(" Of this mesh rays meet only the first and the last surface, as "
                                  "of a solid body: {}.",
                                  facets.whyNot)
                    : fmt::format(" Rays are followed among {} flat facets.", facets.planes.size());
        }
    }
}

/// Sets all effects of the object to out, since it is not drawn; effects of the whole picture stay.
void takeOut(std::vector<EffectRow>& rows, const std::string& reason) {
    for (EffectRow& row : rows) {
        if (row.in && !row.isOfPicture) {
            row.in = false;
            row.removable = false;
            row.line.reason = reason;
        }
    }
}

/// Returns true when the renderer would leave the object out, because it is outside the picture.
bool isOutside(const Scene& scene, std::size_t object, const MeshView& mesh, const Catalog& catalog,
               double aspect) {
    const glm::dmat4 worldToClip =
        projection(scene.camera, aspect, DepthRange()) * viewMatrix(scene.camera);
    return !mesh.indices.empty() &&
           patina::isOutside(placementOf(scene.objects[object], mesh.bounds), worldToClip,
                             shellsLength(scene.objects[object].material, catalog));
}

} // namespace

std::string whyNotDrawn(const Scene& scene, std::size_t object, const Catalog& catalog,
                        const MeshSource& meshes, double aspect) {
    if (!scene.objects[object].visible) {
        return "The object is hidden.";
    }
    if (!canBeSeen(scene.objects[object].material)) {
        return "Nothing of the object can be seen: its opacity is 0.";
    }
    return aspect > 0.0 && isOutside(scene, object, meshes(scene.objects[object]), catalog, aspect)
               ? "The object is outside the view: it is not drawn."
               : "";
}

std::vector<EffectRow> objectRows(const Scene& scene, std::size_t object, const Catalog& catalog,
                                  const MeshSource& meshes, const KnownImages& images,
                                  double aspect) {
    const EffectView view = objectView(scene, object, catalog, meshes);
    std::vector<EffectRow> rows = effectRows(scene, object, catalog, view);
    const Material& material = scene.objects[object].material;
    if (const std::string why = whyNotDrawn(scene, object, catalog, meshes, aspect); !why.empty()) {
        takeOut(rows, why);
        return rows;
    }
    const MeshView mesh = meshes(scene.objects[object]);
    addUnreached(rows, scene, object, catalog, view, mesh);
    describeImages(rows, material, catalog, mesh, images);
    describeEnvironment(rows, images);
    describeFacets(rows, material, catalog, mesh);
    return rows;
}

} // namespace patina
