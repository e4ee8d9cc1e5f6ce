// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/error.h"
#include "core/mesh.h"
#include "render/gpu/hdr_numbers.h"
#include "scene/scene.h"

namespace patina {

struct EnvironmentImage;

/// Says which frame is wanted, apart from the scene.
struct View {
    glm::ivec2 size{512, 512}; ///< pixels, at least 1
    Camera camera;
    /// Is how many pixels a unit of those lengths has that keep their size on a screen: its device
    /// pixel ratio.
    double pixelRatio = 1.0;
    int samples = 0; ///< is the samples per pixel (MSAA), lowered to what the driver offers; 0 for
                     ///< the scene's own number
    HdrNumbers numbers = HdrNumbers::Half; ///< are those of the linear picture
    /// Is the scene whose effects the programs have; null for the scene itself. It has the same
    /// objects and lights with other values, so that no program is compiled while a value passes
    /// the point at which an effect is needed.
    const Scene* effects = nullptr;
    /// Is the picture of the scene's environment; while it is null the environment is black.
    std::shared_ptr<const EnvironmentImage> environmentImage;
    /// Is how many directions per pixel are sampled for an environment's light, from four on in
    /// whole rounds of four; 0 chooses a number that takes about as long as the lights.
    int environmentSamples = 0;
    /// Chooses the random series of directions; different series are independent.
    int environmentSeries = 0;
    /// Limits the samples per pixel to which frames that continue add up.
    int maxSamples = 1 << 24;
    /// Says that nothing has changed and more samples are wanted: the picture becomes the mean of
    /// all frames since the last new one.
    bool isContinued = false;
    /// Says that the scene is changing: an environment's light that is sampled is fitted instead,
    /// so that each frame has all of it without noise.
    bool isMoving = false;
};

/// Says what a frame is drawn for.
enum class FramePurpose {
    Window,  ///< is shown in a window, which must not stand still
    Sketch,  ///< is a first look before that: half as wide and high, with one sample per pixel
    Capture, ///< is read back: all that it needs is prepared in one step
    Prewarm, ///< only makes the programs, so that a later frame need not wait for them
    Targets  ///< only allocates the targets, while its programs are made elsewhere
};

/// Returns the mesh of an object, or an empty view while it is not there yet.
using MeshSource = std::function<MeshView(const Object&)>;

/// Holds what drawing a frame took, its effects and its messages.
struct FrameReport {
    int programs = 0;        ///< counts the different programs used
    int compiled = 0;        ///< counts the programs compiled (not found in memory or on disk) for
                             ///< this frame
    int uploadedBuffers = 0; ///< counts the uniform buffers written
    int drawnObjects = 0;
    int drawCalls = 0;      ///< counts the calls for objects; those of one mesh and material share
                            ///< one
    bool isWaiting = false; ///< says that images are incomplete: another frame shows more of them
    int shadowMaps = 0;     ///< counts the shadow maps drawn (six for a light that shines
                            ///< everywhere)
    int filledTables = 0;   ///< counts the materials whose tables or lobes were filled
    std::vector<std::string> effects; ///< names the effects in the programs, each once
    Errors messages;          ///< has compile errors at the block's own file and line, lost lights,
                              ///< ...
    std::size_t warnings = 0; ///< counts the messages at the end that say what was left out of an
                              ///< otherwise correct frame
};

} // namespace patina
