// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ball_stage.h"
#include "catalog/catalog.h"
#include "render/gpu/uniform_buffer.h"
#include "render/pass/pipeline_store.h"

namespace patina::benchmarks {

/// Is the program that the engine assembles for the first object of a scene, with its data.
class AssembledProgram {
  public:
    AssembledProgram(const std::shared_ptr<const Catalog>& catalog, const Scene& scene,
                     const BallStage& stage);

    void use();

    const Pipeline& pipeline() const { return *pipeline_; }

  private:
    std::shared_ptr<const Pipeline> pipeline_;
    UniformBuffer view_;
    UniformBuffer scene_;
    UniformBuffer object_;
};

} // namespace patina::benchmarks
