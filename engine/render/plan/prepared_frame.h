// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "render/plan/draw_list.h"
#include "render/plan/frame_plan.h"

namespace patina {

/// Holds what the passes make of a plan before they draw it: meshes of the GPU, programs, places in
/// buffers, and the order of drawing. Preparing a frame writes it; drawing reads it.
struct PreparedFrame {
    const FramePlan& plan;
    std::vector<std::shared_ptr<GpuMesh>> meshes; ///< has one for each item of the plan
    std::vector<DrawMaterial> materials;          ///< has one for each material of the plan
    std::shared_ptr<const Pipeline> ground; ///< is null when there is no program to draw it with
    DrawList list;
    DepthRange layerDepths;           ///< covers only transparent objects
    std::vector<const void*> sources; ///< has pointers to the sources of the programs and their
                                      ///< messages

    explicit PreparedFrame(const FramePlan& planned) : plan(planned) {}

    /// Drops what was made of the last plan; the memory of the lists is kept.
    void begin();

    /// Tells whether edges of meshes with the material are drawn as lines.
    bool hasLines(std::size_t material) const;
};

} // namespace patina
