// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gpu/hdr_target.h"
#include "render/pass/frame_data.h"
#include "render/pass/frame_environment.h"
#include "render/pass/frame_shadows.h"
#include "render/pass/render_resources.h"

namespace patina {

/// Holds the GPU objects that draw one view: a reference to what views share, and the view's own
/// data, environment and targets.
struct FrameGpu {
    /// Keeps a reference to `resources`, which must outlive it.
    explicit FrameGpu(RenderResources& resources)
        : shared(resources), textures{shared.textures}, shadows(shared.shadows), data(*this) {}

    /// Returns the target that is drawn into; a sketch has its own, so that the frames' target is
    /// kept.
    HdrTarget& target() { return isSketch ? sketchTarget : frameTarget; }

    /// Fits the target to the plan and returns true when its images were made again.
    /// `isReadBetween` is that of HdrTarget::fit().
    Result<bool> fitTarget(const FramePlan& plan, bool isReadBetween);

    /// Binds the target, the data and the state for drawing objects; endObjects() follows in the
    /// same step.
    void beginObjects();
    static void endObjects();

    /// Returns the picture that was drawn last, linear.
    const gl::Texture& picture();
    unsigned pictureFramebuffer();

    RenderResources& shared;
    FrameReport report;
    FrameTextures textures;
    FrameShadows shadows;
    FrameData data;
    FrameEnvironment environment;
    HdrTarget frameTarget;
    HdrTarget sketchTarget; ///< has memory only while there is a sketch
    bool isSketch = false;
};

/// Names the depth and blend state with which objects are drawn.
enum class BlendState {
    Opaque,  ///< shows what is nearest
    Depths,  ///< writes depths alone
    Blended, ///< blends over what is there, where the depth is at most that in the target
};
void setBlendState(BlendState state);

/// Unbinds what a frame has bound, for whoever draws next.
void leaveState();

} // namespace patina
