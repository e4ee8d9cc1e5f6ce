// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/unreached_lights.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "render/light_lists.h"
#include "shading/effect_choice.h"
#include "shading/light_effects.h"

namespace patina {
namespace {

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

} // namespace

std::vector<EffectRow> unreachedRows(const Scene& scene, std::size_t object,
                                     const Catalog& catalog, const MeshSource& meshes) {
    std::vector<EffectRow> rows;
    const MeshView mesh = meshes(scene.objects[object]);
    if (mesh.indices.empty()) {
        return rows;
    }
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
    return rows;
}

} // namespace patina
