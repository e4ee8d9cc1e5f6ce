// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/pass/batch_drawer.h"
#include "render/pass/layer_composer.h"

namespace patina {

/// Draws the transparent objects that LayerComposer composes, layer by layer or all at once.
class LayerPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "transparent objects"; }
    void forget() override { composer_.forget(); }

    /// Frees the memory of the layers.
    void release() { composer_.leaveOut(); }

  private:
    bool isLayered(const DrawMaterial& material) const;
    Result<void> addMaterials(PreparedFrame& frame, ProgramCache& programs);
    void drawLines(const PreparedFrame& frame, FrameGpu& gpu);
    bool compose(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget);
    bool drawObjects(const PreparedFrame& frame, FrameGpu& gpu, LayerComposer::Stage stage,
                     StepBudget& budget);

    LayerComposer composer_;
    std::size_t batch_ = 0; ///< is the transparent batch that is drawn next into the current layer
    bool hasLines_ = false;
    bool isDone_ = false;
    BatchDrawer drawer_;
};

} // namespace patina
