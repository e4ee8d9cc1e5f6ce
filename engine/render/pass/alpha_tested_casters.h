// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include <glm/mat4x4.hpp>

#include "render/gpu/gpu_texture_store.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/uniform_buffer.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Holds the materials of a frame that an image decides the shadows of, and the programs for them.
class AlphaTestedCasters {
  public:
    /// The shader files may have changed.
    void forget() { pipelines_.clear(); }

    /// Begins a frame.
    void clear() { count_ = 0; }

    /// Returns one more material, with the opacity that its image takes from; its number counts
    /// from 0.
    std::size_t add(const Material& material, double opacity);

    /// Makes their programs, and looks whether their images are there.
    Result<void> prepare(const std::shared_ptr<const Catalog>& catalog, ProgramCache& programs,
                         const GpuTextureStore& textures);

    /// Tells whether what decides their shadows has changed since noteDrawn().
    bool hasChanged() const { return hasChanged_; }
    void noteDrawn() { hasChanged_ = false; }

    /// Uses the program of a material, with its data and its image.
    void use(std::size_t number, const glm::mat4& worldToMap, FrameTextures& textures);

  private:
    /// Holds what of a material its shadows depend on.
    struct Caster {
        Material material;       ///< its opacity and the image of that alone
        std::uint64_t state = 0; ///< of the image
        std::shared_ptr<const Pipeline> pipeline;
    };
    using Key = std::tuple<TextureChannel, TextureMode, bool>;

    Result<std::shared_ptr<const Pipeline>>
    pipelineFor(const Material& material, const std::shared_ptr<const Catalog>& catalog,
                ProgramCache& programs);

    std::vector<Caster> casters_; ///< kept for their memory: the first count_ are the frame's
    std::size_t count_ = 0;
    bool hasChanged_ = false;
    std::map<Key, std::shared_ptr<const Pipeline>> pipelines_;
    UniformBuffer data_;
};

} // namespace patina
