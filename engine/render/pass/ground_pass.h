// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "render/gpu/gpu_mesh.h"
#include "render/gpu/instance_buffer.h"
#include "render/gpu/uniform_buffer.h"
#include "render/pass/pass.h"

namespace patina {

/// Draws the ground, a plane or its shadows alone, after the solid objects, which hide it.
class GroundPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "ground"; }

  private:
    void makeMesh();

    UniformBuffer data_;
    SingleInstance instance_;
    std::optional<GpuMesh> mesh_; ///< is made when it is first needed
    bool isDrawn_ = false;
};

} // namespace patina
