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

/// Says how many bytes of images a frame may still upload. `isWaiting` is true when some image is
/// incomplete, so that another frame will show more of it.
struct TextureBudget {
    static constexpr std::size_t everything = std::numeric_limits<std::size_t>::max();

    std::size_t bytesLeft = everything;
    bool isWaiting = false;
};

/// Holds images for as long as a view shows them.
using ShownTextures = std::vector<std::shared_ptr<const GpuTexture>>;

/// Owns the images in the GPU's memory; each is there once for all materials that show it.
class GpuTextureStore {
  public:
    void setSource(TextureSource source) { source_ = std::move(source); }

    /// Binds the images of a material that the program shows. While an image is still loading, the
    /// object's `data` give it no weight; one that cannot be read is shown as a checker. Leaves
    /// texture unit 0 active.
    void bind(std::span<glm::vec4> data, const Pipeline& pipeline, const Material& material,
              TextureBudget& budget, ShownTextures& shown);

    /// Returns the image of a use as its source has it, for what is no material.
    TextureLookup look(const TextureUse& use, TextureDecoding decoding) const {
        return source_ ? source_(use, decoding) : TextureLookup{nullptr, true};
    }

    /// Returns a number that changes when bind() would show another state of one image of the
    /// material.
    std::uint64_t stateOf(const BoundTexture& image, const Material& material) const;

    /// Ends a frame and deletes images that were not drawn for 120 frames and that no view shows.
    void endFrame();

  private:
    struct Entry {
        std::shared_ptr<const TexturePicture> picture; ///< is held so that no other picture gets
                                                       ///< its address
        std::shared_ptr<GpuTexture> texture;
        std::uint64_t lastFrame = 0;
    };

    /// Is a picture, and whether it is shown as opaque.
    using EntryKey = std::pair<const TexturePicture*, bool>;

    void bindOne(const BoundTexture& image, const Material& material, glm::vec4& data,
                 TextureBudget& budget, ShownTextures& shown);
    std::shared_ptr<const GpuTexture> show(const std::shared_ptr<const TexturePicture>& picture,
                                           bool isOpaque, TextureBudget& budget);
    const gl::Sampler& sampler(const TextureUse& use);

    TextureSource source_;
    std::map<EntryKey, Entry> entries_;
    std::array<std::optional<gl::Sampler>, 6> samplers_; ///< holds one for each wrap and filter,
                                                         ///< made when first used
    std::uint64_t frame_ = 0;
};

/// Holds the images and the upload budget of one view's frames, since other views use the same
/// store in between.
struct FrameTextures {
    /// Begins a frame that uploads at most `bytes`.
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
