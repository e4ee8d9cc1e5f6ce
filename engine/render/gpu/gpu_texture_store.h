// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/sampler.h"
#include "render/gpu/gpu_texture.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/texture_source.h"

namespace patina {

/// Says how many bytes of images a frame still takes into the GPU's memory, and whether some are
/// not whole yet, so that another frame shows more of them.
struct TextureBudget {
    static constexpr std::size_t everything = std::numeric_limits<std::size_t>::max();

    std::size_t bytesLeft = everything;
    bool isWaiting = false;
};

/// Holds images for as long as a view shows them.
using ShownTextures = std::vector<std::shared_ptr<const GpuTexture>>;

/// The images that are in the GPU's memory, each once however many materials show it.
class GpuTextureStore {
  public:
    void setSource(TextureSource source) { source_ = std::move(source); }

    /// Binds what the program shows of a material's images. One that is not there yet counts for
    /// nothing in `data`, the object's; one that is missing is a checker. Leaves texture unit 0
    /// active.
    void bind(std::span<glm::vec4> data, const Pipeline& pipeline, const Material& material,
              TextureBudget& budget, ShownTextures& shown);

    /// A number that changes when bind() would show another state of one image of the material.
    std::uint64_t stateOf(const BoundTexture& image, const Material& material) const;

    /// Forgets what was not drawn for a while and no view shows.
    void endFrame();

  private:
    struct Entry {
        std::shared_ptr<const TexturePicture> picture; ///< kept, so that its address stays its own
        std::shared_ptr<GpuTexture> texture;
        std::uint64_t lastFrame = 0;
    };

    /// A picture, and whether it is shown as an opaque one.
    using EntryKey = std::pair<const TexturePicture*, bool>;

    void bindOne(const BoundTexture& image, const Material& material, glm::vec4& data,
                 TextureBudget& budget, ShownTextures& shown);
    std::shared_ptr<const GpuTexture> show(const std::shared_ptr<const TexturePicture>& picture,
                                           bool isOpaque, TextureBudget& budget);
    const gl::Sampler& sampler(const TextureUse& use);

    TextureSource source_;
    std::map<EntryKey, Entry> entries_;
    std::array<std::optional<gl::Sampler>, 6> samplers_; ///< by wrap and filter
    std::uint64_t frame_ = 0;
};

/// The images of one view's frames, whatever others take and forget in between.
struct FrameTextures {
    /// Begins a frame that takes at most so many bytes.
    void begin(std::size_t bytes = TextureBudget::everything) {
        budget = {bytes};
        shown.clear();
    }

    void bind(std::span<glm::vec4> data, const Pipeline& pipeline, const Material& material) {
        store.bind(data, pipeline, material, budget, shown);
    }

    GpuTextureStore& store;
    TextureBudget budget{};
    ShownTextures shown{};
};

} // namespace patina
