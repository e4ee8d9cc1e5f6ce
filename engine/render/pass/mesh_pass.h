// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// Uploads the meshes of a frame to the GPU, with the edges of those with outlines or fins, the
/// marks of those with strokes, and how those bend whose models read that.
class MeshPass : public Pass {
  public:
    /// Allocates meshes that are new.
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;

    /// Uploads their content, some megabytes at a time.
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "meshes"; }

  private:
    static void takeColors(const PreparedFrame& frame);
    static bool findEdges(const PreparedFrame& frame, FrameGpu& gpu, const StepBudget& budget);
    static bool findCurvature(const PreparedFrame& frame, FrameGpu& gpu, const StepBudget& budget);
    static bool setMarks(const PreparedFrame& frame, FrameGpu& gpu, const StepBudget& budget);
};

} // namespace patina
