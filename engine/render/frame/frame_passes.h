// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "render/pass/background_pass.h"
#include "render/pass/blended_pass.h"
#include "render/pass/depth_normal_pass.h"
#include "render/pass/display_pass.h"
#include "render/pass/fin_pass.h"
#include "render/pass/ground_pass.h"
#include "render/pass/layer_pass.h"
#include "render/pass/mesh_pass.h"
#include "render/pass/outline_pass.h"
#include "render/pass/program_pass.h"
#include "render/pass/resolve_pass.h"
#include "render/pass/shadow_pass.h"
#include "render/pass/solid_pass.h"
#include "render/pass/stroke_pass.h"
#include "render/pass/target_pass.h"

namespace patina {

/// Owns the passes of a frame and knows their orders.
struct FramePasses {
    /// Returns the passes in the order of preparing: each needs only what those before it have
    /// added to the plan.
    std::array<Pass*, 16> prepared(FrameData& data) {
        return {&meshes,   &shadows, &display,      &target, &background, &programs,
                &data,     &layers,  &solid,        &fins,   &ground,     &strokes,
                &outlines, &blended, &depthNormals, &resolve};
    }

    /// Returns the passes that are drawn first, in their order; then objects() are drawn, then
    /// `depthNormals` and `resolve`.
    std::array<Pass*, 3> beforeObjects() { return {&meshes, &shadows, &target}; }
    std::array<Pass*, 8> objects() {
        return {&solid, &fins, &background, &ground, &strokes, &outlines, &blended, &layers};
    }

    MeshPass meshes;
    ShadowPass shadows;
    DisplayPass display;
    TargetPass target;
    BackgroundPass background;
    ProgramPass programs;
    LayerPass layers;
    SolidPass solid;
    FinPass fins;
    GroundPass ground;
    StrokePass strokes;
    OutlinePass outlines;
    BlendedPass blended;
    DepthNormalPass depthNormals;
    ResolvePass resolve;
};

} // namespace patina
