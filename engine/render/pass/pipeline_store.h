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

/// Keeps pipelines by the keys of their effects. Asking for one that is there allocates
/// nothing.
class PipelineStore {
  public:
    struct Entry {
        std::shared_ptr<const Pipeline> pipeline; ///< null when it does not compile
        Errors errors;
        bool isFinal = true; ///< false: asked again, a block in it is still being tried
    };

    explicit PipelineStore(std::filesystem::path programCache,
                           SurfaceOutput output = SurfaceOutput::Picture);

    /// Returns the vec4s of the scene's block in its programs: as many as the driver has room for.
    int sceneCapacity() const { return sceneCapacity_; }

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Holds what a pipeline is made for beside the material; the key is EffectKey::ofScene().
    struct Surroundings {
        const Scene& scene;
        std::uint64_t key = 0;
        EffectView view{};
    };

    /// Returns the pipeline for a material, whose key is EffectKey::ofMaterial().
    const Entry& get(const Material& material, std::uint64_t materialKey,
                     const Surroundings& surroundings);

    /// Tells whether get() would find it, made before.
    bool has(std::uint64_t materialKey, std::uint64_t sceneKey) const {
        return hasFinal({materialKey, sceneKey});
    }

    /// Tells whether ground() would find it, made before.
    bool hasGround(GroundMode mode, std::uint64_t sceneKey) const {
        return hasFinal({keyOf(mode), sceneKey});
    }

    /// Returns a plain fallback for an object whose own program never compiled.
    const Entry& fallback(const Surroundings& surroundings);

    /// Returns the scene's ground, which must be seen.
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

    std::shared_ptr<const Catalog> catalog_;
    ProgramCache programs_;
    SurfaceOutput output_;
    int sceneCapacity_;
    std::map<Key, Entry> entries_;
};

} // namespace patina
