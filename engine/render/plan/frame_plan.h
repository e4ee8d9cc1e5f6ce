// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/mesh.h"
#include "render/lights/frustum.h"
#include "render/lights/ground_place.h"
#include "render/lights/light_kinds.h"
#include "render/lights/light_lists.h"
#include "render/lights/placement.h"
#include "render/view.h"
#include "shading/effects/effect_view.h"

namespace patina {

/// Is one of the different materials of a frame; many objects may have it.
struct PlannedMaterial {
    std::size_t object = 0;  ///< is the first object that has it
    std::size_t missing = 0; ///< is LightKinds::missingKinds() for its objects
    bool isTransparent = false;
    bool canShadow = true;
    bool isOutlined = false; ///< says that the edges of its objects' meshes are wanted
    double shells = 0.0;     ///< is how far strands reach from the surface, in metres
    int layers = 0;          ///< is how many layers of strands are drawn over the surface
    bool hasFins = false;    ///< says that strands stand on the edges of its objects' meshes

    double marks = 0.0;      ///< is how many marks of strokes there are, as marksPerUnit()

    bool needsEdges() const { return isOutlined || hasFins; }
};

/// Says what is seen of one object of a scene.
struct PlannedItem {
    std::size_t index = 0; ///< is the object's index in the scene
    MeshView view;
    const Placement* placement = nullptr;
    double distance = 0.0;    ///< metres from the eye to the middle of its box
    std::size_t lights = 0;   ///< is the number of its list in LightLists
    std::size_t material = 0; ///< is an index into FramePlan::materials
    double marks = 0.0; ///< is how many marks are drawn at most on a square metre of its mesh
    bool isInPicture = true;
};

/// Says whether and how a frame's ground is drawn.
struct PlannedGround {
    bool isSeen = false;
    GroundPlace place;
    std::size_t lights = 0;  ///< is the number of its list in LightLists
    std::size_t missing = 0; ///< is LightKinds::missingKinds() for it
};

/// Holds what a frame shows: objects and their materials, the lights that reach them, the ground,
/// the camera and the range of depths. FramePlanner makes it from a scene and a view alone, without
/// the GPU; what the passes make of it is PreparedFrame.
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
    std::vector<PlannedItem> items;         ///< has the items in the scene's order
    std::vector<PlannedMaterial> materials; ///< has the different materials of the items
    LightLists lightLists;
    LightKinds lightKinds;
    PlannedGround ground;
    EffectView effectView; ///< is what the programs depend on in the view, except missing lights
    std::int64_t triangles = 0;
    std::int64_t layered = 0; ///< is the number of triangles of layers of strands
    std::int64_t edges = 0; ///< is about the number of edges that may be drawn as outlines or fins

    glm::dmat4 worldToClip() const;

    /// Returns how wide a pixel of the picture is one metre before the eye, in metres.
    double pixelWidth() const;

    /// Returns how many pixels are a unit of the lengths of marks: as in passes over the picture,
    /// this is 512 units high.
    double pixelsPerUnit() const;

    /// Returns the values of one of the materials.
    const Material& material(std::size_t number) const;

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
