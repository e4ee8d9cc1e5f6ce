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
#include "shading/program/parameter_packer.h"

namespace patina {

/// Counts the vec4s that were written and the lights that did not fit.
struct PackedScene {
    std::size_t vec4s = 0;
    int lostLights = 0;
};

/// Names a scene and the scene whose effects the pipelines have, which has the same lights with
/// other values.
struct SceneToPack {
    const Scene& scene;
    const Scene& effects;
    std::span<const ShadowView> shadows; ///< has one for each light; lights beyond its end have no
                                         ///< map
    const LightLists* lists = nullptr;   ///< is null where all lights are packed
    std::size_t list = 0;

    bool has(std::size_t light) const { return lists == nullptr || lists->holds(list, light); }
};

/// Fills `sceneData` for a pipeline; `out` is the whole scene block. Lights that do not fit in it
/// are counted in the result. It allocates nothing.
PackedScene packScene(std::span<glm::vec4> out, const Pipeline& pipeline,
                      const SceneToPack& packing, const glm::dmat4& cameraToWorld);

/// Fills `objectData`; `out` has the size pipeline.object.vec4s. It allocates nothing.
void packMaterial(std::span<glm::vec4> out, const Pipeline& pipeline, const Material& material,
                  const PackedAround& around);

/// Fills `objectData` of the program of outlines, but for its fixed part.
void packLines(std::span<glm::vec4> out, const OutlineLayout& layout, const Material& material,
               const PackedAround& around);

/// Holds the values of the block that composes transparent surfaces, and the range of their depths
/// in metres.
struct LayersToPack {
    const Values& values;
    double nearest = 0.0;
    double farthest = 1.0;
};

/// Writes the values and depths to the `objectData` of a transparent surface.
void packLayers(std::span<glm::vec4> out, const Pipeline& pipeline, const LayersToPack& packing,
                const glm::dmat4& cameraToWorld);

/// Holds the place of the ground and the light of the environment that it would reflect if it were
/// white.
struct GroundToPack {
    const GroundPlace& place;
    glm::dvec3 environment{0.0};
};

/// Fills `objectData` of the ground's program; `out` has the size pipeline.object.vec4s.
void packGround(std::span<glm::vec4> out, const Pipeline& pipeline, const Ground& ground,
                const GroundToPack& packing);

/// Fills `viewData`; `out` has the size ViewLayout::vec4s. `pixel` is the width of a pixel of the
/// target in pixels of the picture.
void packView(std::span<glm::vec4> out, const glm::dmat4& worldToClip, const glm::dvec3& eye,
              double pixel);

} // namespace patina
