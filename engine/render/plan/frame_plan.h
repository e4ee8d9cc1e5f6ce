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

/// Says what is drawn of the ground of a frame.
struct PlannedGround {
    bool isSeen = false;
    GroundPlace place;
    std::size_t lights = 0;                   ///< the number of its list
    std::size_t missing = 0;                  ///< of lights, LightKinds::missingKinds() for it
    std::shared_ptr<const Pipeline> pipeline; ///< null: there is nothing to draw it with
};

/// Holds what a frame shows: which objects with which materials, the lights that reach them, the
/// ground, where the camera is and how deep all of it reaches. FramePlanner makes it from a scene
/// and a view alone; what prepares the frame adds meshes of the GPU, programs and the order of
/// drawing.
struct FramePlan {
    const Scene* scene = nullptr;   ///< whose values are drawn
    const Scene* effects = nullptr; ///< whose effects the programs have: often the scene itself
    const View* view = nullptr;
    bool isHeld = false;   ///< the effects are not the scene's own, and a drag must not compile
    bool isUnseen = false; ///< it is drawn for its programs alone
    glm::dmat4 worldToCamera{1.0};
    glm::dmat4 cameraToWorld{1.0};
    glm::dvec3 eye{0.0}; ///< in world space
    DepthRange depths;
    DepthRange layerDepths;              ///< of what is transparent
    std::vector<DrawItem> items;         ///< in the scene's order
    std::vector<DrawMaterial> materials; ///< of the items
    LightLists lightLists;
    LightKinds lightKinds;
    PlannedGround ground;
    EffectView effectView; ///< what the view says to the programs, but for missing lights
    DrawList list;
    std::vector<const void*> sources; ///< what the programs and their messages come from
    std::int64_t triangles = 0;
    std::int64_t edges = 0; ///< about so many that may have lines

    glm::dmat4 worldToClip() const;

    /// Returns the scene's values for the block by which the programs put together what is
    /// transparent.
    const BlockValues& transparency() const;

    /// Tells whether there are so many triangles that they, not the pixels, are what takes long.
    bool hasManyTriangles(std::int64_t more = 0) const;

    /// Goes on with copies of the scene and the one of the effects.
    void moveTo(const Scene& copy, const Scene& effectsCopy);
};

} // namespace patina
