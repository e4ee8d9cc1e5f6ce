// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture_array.h"
#include "render/gpu/draw_slices.h"
#include "render/pass/shadow_casters.h"
#include "render/pass/shadow_layers.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Holds the depth maps' images, what they show, and the images of the casters.
struct ShadowTargets {
    const gl::TextureArray& texture;
    std::span<ShadowLayers::Layer> layers;
    ShadowCasters& casters;
    FrameTextures& textures;
};

/// Draws the layers of depth maps in steps, and knows where it goes on.
class ShadowDrawer {
  public:
    /// The shader files may have changed.
    void forget() { program_.reset(); }

    Result<void> prepare(const Catalog& catalog, ProgramCache& programs);

    /// Tells whether it can draw into the images.
    Result<void> check(const gl::TextureArray& texture);

    /// Begins with the first layer.
    void restart();

    /// Draws about so many triangles of the layers that are not drawn.
    void drawSome(const ShadowTargets& targets, std::int64_t triangles);

  private:
    void beginLayer(const ShadowTargets& targets);
    void beginRun(const ShadowTargets& targets);

    std::shared_ptr<const gl::Program> program_;
    gl::Framebuffer framebuffer_;
    std::size_t layer_ = 0; ///< where drawing goes on
    bool isBegun_ = false;  ///< runs_ are those of layer_
    std::vector<ShadowCasters::Run> runs_;
    InstanceBuffer instances_;
    std::size_t run_ = 0;
    DrawSlices slices_;
};

} // namespace patina
