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

/// Holds what the shadows of an alpha-tested material depend on.
struct AlphaTest {
    double opacity = 1.0; ///< is the value that the image modifies, 0 .. 1
    TextureUse image;
    std::uint64_t state = 0; ///< is GpuTextureStore::stateOf() of the image

    friend bool operator==(const AlphaTest&, const AlphaTest&) = default;
};

/// Holds the materials of a frame whose shadows are cut out by an image, and the programs that draw
/// them into shadow maps.
class AlphaTestedCasters {
  public:
    /// Drops all programs, because the shader files may have changed.
    void forget() { pipelines_.clear(); }

    /// Begins a frame.
    void clear() { tests_.clear(); }

    /// Adds a material and returns its index. `opacity`, 0 .. 1, is the value that its image
    /// modifies.
    std::size_t add(const Material& material, double opacity);

    /// Makes the programs and notes whether the images are loaded. Fails when a program does not
    /// compile.
    Result<void> prepare(const std::shared_ptr<const Catalog>& catalog, ProgramCache& programs,
                         const GpuTextureStore& textures);

    /// Returns what the shadows of each material depend on.
    const std::vector<AlphaTest>& tests() const { return tests_; }

    /// Makes the program of a material current and binds its data and its image.
    void use(std::size_t number, const glm::mat4& worldToMap, FrameTextures& textures);

  private:
    struct Caster {
        Material material; ///< has only the opacity and its image
        std::shared_ptr<const Pipeline> pipeline;
    };
    using Key = std::tuple<TextureChannel, TextureMode, bool>;

    Result<std::shared_ptr<const Pipeline>>
    pipelineFor(const Material& material, const std::shared_ptr<const Catalog>& catalog,
                ProgramCache& programs);

    std::vector<AlphaTest> tests_; ///< has one for each of the frame's materials
    std::vector<Caster> casters_;  ///< holds those materials first; the others keep their memory
    std::map<Key, std::shared_ptr<const Pipeline>> pipelines_;
    UniformBuffer data_;
};

} // namespace patina
