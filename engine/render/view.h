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
    glm::ivec2 size{512, 512}; ///< pixels, each at least 1
    Camera camera;
    int samples = 0; ///< MSAA, lowered to what the driver offers; 0: the scene's own
    HdrNumbers numbers = HdrNumbers::Half; ///< of the linear picture
    /// Whose effects the programs have; nothing: the scene's own. The same objects and lights with
    /// other values, so that a value may pass what makes an effect needless without a new program.
    const Scene* effects = nullptr;
    /// Is the picture of the scene's environment; nothing: it is not there yet, and black.
    std::shared_ptr<const EnvironmentImage> environmentImage;
    /// Directions per pixel that are drawn for an environment's light, from four on in whole rounds
    /// of four; 0: what takes about as long as the lights.
    int environmentSamples = 0;
    /// Directions of one series have nothing to do with those of another, whatever their number.
    int environmentSeries = 0;
    /// Is where a frame that continues stops to add: so many samples are in the picture then.
    int maxSamples = 1 << 24;
    /// Nothing has changed but that more samples are wanted: the picture is the mean of all since
    /// the last frame that was new.
    bool isContinued = false;
    /// The scene is changing: where its environment's light is sampled it is fitted instead, so
    /// that each frame has all of it without grain.
    bool isMoving = false;
};

/// Tells what a frame is drawn for.
enum class FramePurpose {
    Window,  ///< to be seen, in a window that must not stand still
    Sketch,  ///< a first look before that: half as wide and high, with one sample per pixel
    Capture, ///< to be kept: all that it needs is prepared in one step
    Prewarm, ///< for its programs, so that a frame need not wait for them; nothing is shown
    Targets  ///< for what it is drawn into, while its programs are made elsewhere
};

/// Gives the triangles of a mesh name, or an empty view while it is not there yet.
using MeshSource = std::function<MeshView(const Object&)>;

/// Holds what drawing a frame took and what it was made of.
struct FrameReport {
    int programs = 0;        ///< different programs used
    int compiled = 0;        ///< programs compiled (not found in memory or on disk) for this frame
    int uploadedBuffers = 0; ///< uniform buffers written
    int drawnObjects = 0;
    int drawCalls = 0;      ///< for the objects; those of one mesh and material share one
    bool isWaiting = false; ///< images are not whole yet: another frame shows more of them
    int shadowMaps = 0;     ///< depth maps drawn (six for a light that shines everywhere)
    int filledTables = 0;   ///< materials whose blocks' tables were filled (see block_table.h)
    std::vector<std::string> effects; ///< the blocks in the shaders, canonical order
    Errors messages;          ///< compile errors at the block's own file and line, lost lights, ...
    std::size_t warnings = 0; ///< so many of the messages, the last ones, say what was left out of
                              ///< a frame that is otherwise what was asked for
};

} // namespace patina
