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

/// Names the shadow maps' images, what each layer shows, the casters and their images.
struct ShadowTargets {
    const gl::TextureArray& texture;
    std::span<ShadowLayers::Layer> layers;
    ShadowCasters& casters;
    FrameTextures& textures;
};

/// Draws the layers of shadow maps in steps, and remembers how far it came.
class ShadowDrawer {
  public:
    /// Drops the program, because the shader files may have changed.
    void forget() { program_.reset(); }

    Result<void> prepare(const Catalog& catalog, ProgramCache& programs);

    /// Fails when the driver cannot draw into the images.
    Result<void> check(const gl::TextureArray& texture);

    /// Makes drawSome() begin again with the first layer.
    void restart();

    /// Draws about `triangles` triangles of the layers that are not drawn yet.
    void drawSome(const ShadowTargets& targets, std::int64_t triangles);

  private:
    void beginLayer(const ShadowTargets& targets);
    void beginRun(const ShadowTargets& targets);

    std::shared_ptr<const gl::Program> program_;
    gl::Framebuffer framebuffer_;
    std::size_t layer_ = 0; ///< is the layer that is drawn next
    bool isBegun_ = false;  ///< says that runs_ are those of layer_
    std::vector<ShadowCasters::Run> runs_;
    InstanceBuffer instances_;
    std::size_t run_ = 0;
    DrawSlices slices_;
};

} // namespace patina
