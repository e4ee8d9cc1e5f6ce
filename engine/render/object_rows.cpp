// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/object_rows.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/image_places.h"
#include "render/light_lists.h"
#include "render/scene_depth.h"
#include "shading/effect_choice.h"
#include "shading/light_effects.h"
#include "shading/texture_choice.h"

namespace patina {
namespace {

constexpr std::string_view textureKind = "texture/";

/// Where a light with a reach is.
glm::dvec3 placeOf(const Light& light, const Block& block) {
    const Parameter* from = block.parameter(block.reach->from);
    const auto* place = from == nullptr ? nullptr
                                        : std::get_if<glm::dvec3>(
                                              &givenValue(*from, light.block.parameters));
    return place == nullptr ? glm::dvec3(0.0) : *place;
}

std::string whyUnreached(const Light& light, const Block& block, const Ball& ball) {
    const double away =
        std::max(glm::distance(placeOf(light, block), ball.center) - ball.radius, 0.0);
    return fmt::format("Its range or its cone ends before this object, which begins {:.3g} m away.",
                       away);
}

/// A row for each light that shines and does not reach the object.
void addUnreached(std::vector<EffectRow>& rows, const Scene& scene, std::size_t object,
                  const Catalog& catalog, const MeshView& mesh) {
    LightLists lists;
    lists.begin(scene, catalog);
    const Ball ball = ballAround(mesh.bounds, worldMatrix(scene.objects[object]));
    const std::size_t list = lists.listFor(ball);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = catalog.find("lights", light.block.id);
        if (block != nullptr && canShine(light, *block) && !lists.holds(list, i)) {
            rows.push_back({{lightName(scene, i), {}, whyUnreached(light, *block, ball)},
                            false,
                            false,
                            {}});
        }
    }
}

bool isImage(const EffectRow& row) {
    return row.in && row.line.effect.starts_with(textureKind);
}

/// An image is one colour on a mesh that does not say where it lies.
void nameMissingPlaces(std::vector<EffectRow>& rows, const MeshView& mesh) {
    if (std::ranges::none_of(rows, isImage) || hasImagePlaces(mesh.vertices)) {
        return;
    }
    for (EffectRow& row : rows) {
        if (isImage(row)) {
            row.line.reason =
                "An image is bound to it, but the mesh has no texture coordinates: it is one "
                "colour.";
        }
    }
}

bool isOfThePicture(const EffectRow& row) {
    return row.line.effect == "ground" || row.line.effect == "exposure" ||
           row.line.effect == "tone mapping";
}

/// Of an object that is not drawn nothing is in.
void takeOut(std::vector<EffectRow>& rows, const std::string& reason) {
    for (EffectRow& row : rows) {
        if (row.in && !isOfThePicture(row)) {
            row.in = false;
            row.removable = false;
            row.line.reason = reason;
        }
    }
}

} // namespace

std::vector<EffectRow> objectRows(const Scene& scene, std::size_t object, const Catalog& catalog,
                                  const MeshSource& meshes) {
    std::vector<EffectRow> rows =
        effectRows(scene, object, catalog, objectView(scene, object, catalog, meshes));
    if (!scene.objects[object].visible) {
        takeOut(rows, "The object is hidden.");
        return rows;
    }
    if (!canBeSeen(scene.objects[object].material)) {
        takeOut(rows, "Nothing of the object can be seen: its opacity is 0.");
        return rows;
    }
    const MeshView mesh = meshes(scene.objects[object]);
    if (mesh.indices.empty()) {
        return rows;
    }
    addUnreached(rows, scene, object, catalog, mesh);
    nameMissingPlaces(rows, mesh);
    return rows;
}

} // namespace patina
