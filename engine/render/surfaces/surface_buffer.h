// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/gpu/pipeline.h"

namespace patina {

/// Holds what the program of an object is fed with.
struct BufferedObject {
    std::shared_ptr<const Pipeline> pipeline; ///< null: it is not drawn
    std::vector<glm::vec4> data;              ///< objectData, by pipeline->object
    std::vector<std::size_t> inputs; ///< images that change a parameter, in EffectSet::textures;
                                     ///< what they made of it are the first values
    std::size_t firstSample = 0; ///< the value with the first direction of an environment, if any
    std::size_t firstShare = 0;  ///< the value with the first four lights' shares
};

/// All that the programs of a frame know of each of its pixels, in whole floats, so that others can
/// compute the same frame. Rows from the top.
struct SurfaceBuffer {
    glm::ivec2 size{0};
    glm::vec3 eye{0.0f};
    std::vector<glm::vec4> positions;           ///< in world space; w: the object, from 1 on, or 0
    std::vector<glm::vec4> normals;             ///< unit, on the viewer's side; w: the opacity
    std::vector<glm::vec4> tangents;            ///< unit
    std::vector<std::vector<glm::vec4>> values; ///< what images, environment and shadows
                                                ///< give, value by value
    std::vector<BufferedObject> objects;        ///< of the scene
    std::vector<glm::vec4> sceneData;           ///< by the pipelines' SceneLayout

    std::size_t pixels() const { return positions.size(); }

    /// Returns what a pixel shows; nothing: the background.
    std::optional<std::size_t> objectAt(std::size_t pixel) const;

    /// Returns the place of its middle as shaders know it, (0, 0) at the bottom left.
    glm::dvec2 place(std::size_t pixel) const;
};

} // namespace patina
