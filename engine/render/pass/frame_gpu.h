// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gpu/hdr_target.h"
#include "render/pass/frame_data.h"
#include "render/pass/frame_environment.h"
#include "render/pass/render_resources.h"

namespace patina {

/// Holds what the frames of one view are drawn with: what it shares with other views, and its own
/// data, environment and targets.
struct FrameGpu {
    /// `resources` outlives it.
    explicit FrameGpu(RenderResources& resources)
        : shared(resources), textures{shared.textures}, data(*this) {}

    /// Returns what is drawn into: a sketch leaves the frames' own one as it is.
    HdrTarget& target() { return isSketch ? sketchTarget : frameTarget; }

    /// Makes the target fit the plan; true where it was made anew. `isReadBetween`: it is read
    /// while there is more to draw.
    Result<bool> fitTarget(const FramePlan& plan, bool isReadBetween);

    /// Surround what a step draws of objects.
    void beginObjects();
    static void endObjects();

    /// The picture that was drawn last, linear.
    const gl::Texture& picture();
    unsigned pictureFramebuffer();

    RenderResources& shared;
    FrameReport report;
    FrameTextures textures;
    FrameData data;
    FrameEnvironment environment;
    HdrTarget frameTarget;
    HdrTarget sketchTarget; ///< while there is a sketch
    bool isSketch = false;
};

/// Holds the state that objects are drawn with.
enum class BlendState {
    Opaque,  ///< what is nearest is seen
    Depths,  ///< depths alone
    Blended, ///< over what is there, where the depth is the nearest or the same
};
void setBlendState(BlendState state);

/// Leaves nothing of a frame bound, for whoever draws next.
void leaveState();

} // namespace patina
