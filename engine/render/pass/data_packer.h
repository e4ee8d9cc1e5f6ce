// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render/gpu/pipeline.h"
#include "render/lights/ground_place.h"
#include "render/lights/light_lists.h"
#include "render/lights/shadow_view.h"
#include "scene/scene.h"

namespace patina {

/// Says how many vec4s were written, and how many lights did not fit.
struct PackedScene {
    std::size_t vec4s = 0;
    int lostLights = 0;
};

/// Represents a scene, and the one whose effects the pipelines have: the same lights with other
/// values.
struct SceneToPack {
    const Scene& scene;
    const Scene& effects;
    std::span<const ShadowView> shadows; ///< by light; lights beyond its end have no map
    const LightLists* lists = nullptr;   ///< null: all lights
    std::size_t list = 0;

    bool has(std::size_t light) const { return lists == nullptr || lists->holds(list, light); }
};

/// Fills `sceneData` for a pipeline; `out` holds all of the scene's block. Allocates
/// nothing.
PackedScene packScene(std::span<glm::vec4> out, const Pipeline& pipeline,
                      const SceneToPack& packing, const glm::dmat4& cameraToWorld);

/// Fills `objectData`; `out` holds pipeline.object.vec4s. Allocates nothing.
void packMaterial(std::span<glm::vec4> out, const Pipeline& pipeline, const Material& material,
                  const glm::dmat4& cameraToWorld);

/// Holds the values of the block that puts transparent surfaces together, and the depths between
/// which they lie.
struct LayersToPack {
    const Values& values;
    double nearest = 0.0;
    double farthest = 1.0;
};

/// Adds them to the `objectData` of such a surface.
void packLayers(std::span<glm::vec4> out, const Pipeline& pipeline, const LayersToPack& packing,
                const glm::dmat4& cameraToWorld);

/// Says where the ground is, and the environment's light on it if it were white.
struct GroundToPack {
    const GroundPlace& place;
    glm::dvec3 environment{0.0};
};

/// Fills `objectData` of the ground's program; `out` holds pipeline.object.vec4s.
void packGround(std::span<glm::vec4> out, const Pipeline& pipeline, const Ground& ground,
                const GroundToPack& packing);

/// Fills `viewData`; `out` holds ViewLayout::vec4s. `pixel`: how wide a pixel of the target is in
/// pixels of the picture.
void packView(std::span<glm::vec4> out, const glm::dmat4& worldToClip, const glm::dvec3& eye,
              double pixel);

} // namespace patina
