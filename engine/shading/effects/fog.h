// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Returns the share of a surface `distance` metres away that fog of these values hides, 0 .. 1, or
/// hides at most, by what the block's descriptor says; nothing where it says nothing. `thickness`
/// is the share of its density that fog has on the way, where it falls with height.
std::optional<double> hiddenShare(const Block& block, const Values& values, double distance,
                                  double thickness = 1.0);

/// Returns the most by which the scene's fog can change a display value (0 .. 1) of what is drawn:
/// a bound, so that fog below half of an 8-bit step can be left out unseen. It holds up to the next
/// power of two of the view's distance, so that a camera that moves seldom asks for other programs.
/// Infinite where the block does not say; 0 where the view misses its box.
double maxChange(const Scene& scene, const Block& block, const EffectView& view);

/// Holds a box along the axes of the scene.
struct FogBox {
    glm::dvec3 center{0.0};
    glm::dvec3 size{0.0}; ///< from side to side
};

/// Returns the box that the fog fills, by what its descriptor says; nothing where it fills none.
std::optional<FogBox> fogBox(const Block& block, const Values& values);

/// Describes fog that gets thinner above a height.
struct FogLayer {
    double base = 0.0;      ///< metres
    double thickness = 0.0; ///< so far above the base it has 1/e of its density

    /// Returns the mean share of its density on a straight way between two heights.
    double between(double one, double other) const;
};

/// Returns how the fog's density falls with height, by what its descriptor says.
std::optional<FogLayer> fogLayer(const Block& block, const Values& values);

/// Is half of a step between two display values of 8 bits.
inline constexpr double halfStep = 0.5 / 255.0;

/// Puts fog between the eye and what is drawn. It is left out where it hides nothing, or nobody
/// could see that it does.
struct FogEffect {
    static constexpr bool isKnownToReference = true;

    std::optional<BlockUse> fog;
    bool fogsAtVertices = false; ///< but on the ground

    void choose(const SceneSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use) { admitTo(fog, kinds::fog, use); }
    void addTo(ChoiceHash& hash) const;
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::fog), {}, "The scene has no fog."};
    }
    void place(SceneLayout& layout, const EffectSet& set) const;
    void write(SurfaceText& text) const;
    static bool dependsOnPlaces(const Scene& scene, const Catalog& catalog, std::string_view kind);
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const FogEffect&, const FogEffect&) = default;
};

/// Declares what places the fog at vertices, and returns the statement that does.
std::string writeVertexFog(SurfaceText& text);

} // namespace patina
