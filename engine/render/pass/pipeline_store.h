// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "core/error.h"
#include "render/gpu/pipeline.h"
#include "shading/program/program_cache.h"
#include "shading/program/surface_output.h"

namespace patina {

/// Owns the pipelines by the keys of their effects and compiles those that are missing. It
/// allocates nothing for one that is there.
class PipelineStore {
  public:
    struct Entry {
        std::shared_ptr<const Pipeline> pipeline; ///< is null when it does not compile
        Errors errors;
        bool isFinal = true; ///< is false while a block in it is still being tried; then the store
                             ///< asks again
    };

    explicit PipelineStore(std::filesystem::path programCache,
                           SurfaceOutput output = SurfaceOutput::Picture);

    /// Returns the size of the scene's block in all programs, in vec4s; the driver's limit bounds
    /// it.
    int sceneCapacity() const { return sceneCapacity_; }

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Names what a pipeline depends on besides its material. `key` is EffectKey::ofScene().
    struct Surroundings {
        const Scene& scene;
        std::uint64_t key = 0;
        EffectView view{};
    };

    /// Returns the pipeline for a material; `materialKey` is EffectKey::ofMaterial().
    const Entry& get(const Material& material, std::uint64_t materialKey,
                     const Surroundings& surroundings);

    /// Returns true when get() would not need to compile.
    bool has(std::uint64_t materialKey, std::uint64_t sceneKey) const {
        return hasFinal({materialKey, sceneKey});
    }

    /// Returns true when ground() would not need to compile.
    bool hasGround(GroundMode mode, std::uint64_t sceneKey) const {
        return hasFinal({keyOf(mode), sceneKey});
    }

    /// Returns a plain pipeline for an object whose own program never compiled.
    const Entry& fallback(const Surroundings& surroundings);

    /// Returns the pipeline for the scene's ground, which must be visible.
    const Entry& ground(const Surroundings& surroundings);

    ProgramCache& programs() { return programs_; }

  private:
    using Key = std::pair<std::uint64_t, std::uint64_t>;

    static std::uint64_t keyOf(GroundMode mode) { return 1 + static_cast<std::uint64_t>(mode); }
    bool hasFinal(const Key& key) const;
    const Entry& find(std::uint64_t materialKey, const Material& material,
                      const Surroundings& surroundings);
    Entry make(EffectSet effects, std::uint64_t sceneKey);
    tl::expected<void, Entry> addTables(Pipeline& pipeline, const EffectSet& effects);
    tl::expected<void, Entry> addLobes(Pipeline& pipeline, const EffectSet& effects);
    tl::expected<void, Entry> addOutline(Pipeline& pipeline, const EffectSet& effects);
    tl::expected<void, Entry> addFins(Pipeline& pipeline, const EffectSet& effects);
    tl::expected<void, Entry> addMarks(Pipeline& pipeline, const EffectSet& effects);

    std::shared_ptr<const Catalog> catalog_;
    ProgramCache programs_;
    SurfaceOutput output_;
    int sceneCapacity_;
    std::map<Key, Entry> entries_;
};

} // namespace patina
