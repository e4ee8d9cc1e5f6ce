// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "shading/effects/effect_parts.h"
#include "shading/program/source_builder.h"

namespace patina {

/// Says what an object hides of the environment and of the ambient light from itself, by the
/// openness of its vertices. It is left out where the scene has no such light, and of drawings.
struct OcclusionEffect {
    static constexpr bool isKnownToReference = true;

    bool wantsOcclusion = false; ///< as the scene says
    bool isOccluded = false;

    void choose(const SceneSubject& subject, const EffectSet& set);
    void adjust(const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(wantsOcclusion); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {"occlusion", {}, "The scene's objects hide nothing from themselves."};
    }
    void writeLight(SurfaceText& text) const;
    std::string writeVertex(SourceBuilder& vertex) const;
    std::string_view whyPerPixel(const EffectSet& set) const;
    int bufferValues() const { return isOccluded ? 1 : 0; }
    void writeBuffer(SurfaceText& text, std::size_t place) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const OcclusionEffect&, const OcclusionEffect&) = default;
};

/// Tells whether the scene has light that its objects hide from themselves, and wants that: then
/// the openness of its meshes is needed.
bool needsOpenness(const Scene& scene, const Catalog& catalog);

/// Returns the value of a surface buffer that says how the free directions lie off the mesh's
/// normal (x, y, z), and their share (w); nothing where nothing is hidden.
std::optional<std::size_t> opennessValue(const EffectSet& set);

} // namespace patina
