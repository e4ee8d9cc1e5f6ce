// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>

#include "render/lights/frustum.h"
#include "render/lights/ground_place.h"
#include "render/lights/light_kinds.h"
#include "render/lights/light_lists.h"
#include "render/plan/draw_list.h"
#include "render/view.h"
#include "shading/effects/effect_view.h"

namespace patina {

/// Says whether and how a frame's ground is drawn.
struct PlannedGround {
    bool isSeen = false;
    GroundPlace place;
    std::size_t lights = 0;                   ///< is the number of its list in LightLists
    std::size_t missing = 0;                  ///< is LightKinds::missingKinds() for it
    std::shared_ptr<const Pipeline> pipeline; ///< is null when there is no program to draw it with
};

/// Holds what a frame shows: objects and their materials, the lights that reach them, the ground,
/// the camera and the range of depths. FramePlanner makes it from a scene and a view alone; what
/// prepares the frame adds meshes of the GPU, programs and the order of drawing.
struct FramePlan {
    const Scene* scene = nullptr;   ///< is the scene whose values are drawn
    const Scene* effects = nullptr; ///< is the scene whose effects the programs have; often `scene`
                                    ///< itself
    const View* view = nullptr;
    bool isFrozen = false; ///< says that the effects may not be the scene's own, so that a drag
                           ///< compiles nothing
    bool isUnseen = false; ///< says that the frame is drawn only to compile its programs
    glm::dmat4 worldToCamera{1.0};
    glm::dmat4 cameraToWorld{1.0};
    glm::dvec3 eye{0.0}; ///< in world space
    DepthRange depths;
    DepthRange layerDepths;              ///< covers only transparent objects
    std::vector<DrawItem> items;         ///< has the items in the scene's order
    std::vector<DrawMaterial> materials; ///< has the different materials of the items
    LightLists lightLists;
    LightKinds lightKinds;
    PlannedGround ground;
    EffectView effectView; ///< is what the programs depend on in the view, except missing lights
    DrawList list;
    std::vector<const void*> sources; ///< has pointers to the sources of the programs and their
                                      ///< messages
    std::int64_t triangles = 0;
    std::int64_t edges = 0; ///< is about the number of edges that may be drawn as outlines

    glm::dmat4 worldToClip() const;

    /// Returns the values of the block by which the programs compose transparent objects. They are
    /// those of `effects` when the scene has another block.
    const BlockValues& transparency() const;

    /// Returns true when triangles and edges, with `more` of them, are so many that they take
    /// longer than the pixels.
    bool hasManyTriangles(std::int64_t more = 0) const;

    /// Makes the plan refer to copies of its two scenes.
    void moveTo(const Scene& copy, const Scene& effectsCopy);
};

} // namespace patina
