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

/// Holds the pipeline of an object and the data for it.
struct BufferedObject {
    std::shared_ptr<const Pipeline> pipeline; ///< is null when the object is not drawn
    std::vector<glm::vec4> data;              ///< is `objectData`, laid out by pipeline->object
    std::vector<std::size_t> inputs; ///< are the indices in EffectSet::textures of images that
                                     ///< change a parameter; the first values of a pixel are the
                                     ///< results
    std::size_t firstSample = 0;     ///< is the index of the value with the first direction of an
                                     ///< environment, if any
    std::size_t firstShare = 0; ///< is the index of the value with the first four lights' shares
};

/// Holds the inputs of a frame's programs for each pixel, as 32-bit floats, so that other code can
/// compute the same frame. Rows are from the top.
struct SurfaceBuffer {
    glm::ivec2 size{0};
    glm::vec3 eye{0.0f};
    std::vector<glm::vec4> positions;           ///< are in world space; w is the object's index +
                                                ///< 1, or 0
    std::vector<glm::vec4> normals;             ///< are unit, on the viewer's side; w is the
                                                ///< opacity
    std::vector<glm::vec4> tangents;            ///< are unit vectors
    std::vector<std::vector<glm::vec4>> values; ///< has for each value all pixels: what images,
                                                ///< environment and shadows give
    std::vector<BufferedObject> objects;        ///< has one for each object of the scene
    std::vector<glm::vec4> sceneData;           ///< is laid out by the pipelines' SceneLayout

    std::size_t pixels() const { return positions.size(); }

    /// Returns the object that a pixel shows; nothing for the background.
    std::optional<std::size_t> objectAt(std::size_t pixel) const;

    /// Returns the place of a pixel's middle as in gl_FragCoord: in pixels, (0, 0) at the bottom
    /// left.
    glm::dvec2 place(std::size_t pixel) const;
};

} // namespace patina
