// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shading/effects/effect_parts.h"
#include "shading/effects/light_lines.h"

namespace patina {

/// Represents all lights of one kind with the same compiled values: one loop in the program, or a
/// line for each.
struct LightGroup {
    BlockUse block;
    std::optional<BlockUse> shadow; ///< how their shadows are drawn; nothing: there are none
    bool isInColors = false; ///< they have separate colours for the diffuse term and the highlight
    bool hasAmbient = false; ///< they add to the ambient light
    bool isPolarised = false; ///< they are polarised
    int lines = 0; ///< lights that stand in the program's text; 0: a loop, whose length is data

    /// Says how the rays run that the shadows are cast along.
    ShadowProjection projection() const { return block.block().shadowProjection; }

    /// Tells whether the lights' data has lightColorVec4s beside their block's.
    bool hasColors() const { return isInColors || hasAmbient || isPolarised; }

    /// Tells groups apart by a number, whatever they have of lines: lightKey() of their lights.
    std::uint64_t key() const;

    friend bool operator==(const LightGroup&, const LightGroup&) = default;
};

/// Returns the group of one light; nothing when it is left out. `hasShadows`: shadows can be seen
/// in the scene (as hasShadows() says).
std::optional<LightGroup> lightGroup(const Light& light, const Catalog& catalog, bool hasShadows);

/// Returns the key of a light's group; 0 when it is left out.
std::uint64_t lightKey(const Light& light, const Catalog& catalog, bool hasShadows);

/// Tells whether a light can send anything.
bool canShine(const Light& light, const Block& block);

/// Returns what people call a light: by its name, or by its number where it has none.
std::string lightName(const Scene& scene, std::size_t index);

/// Returns the names of the lights in some groups, group by group, in the scene's order.
std::vector<std::string> lightNames(const std::vector<const LightGroup*>& groups,
                                    const EffectSubject& subject);

/// Returns "Key, Fill and Rim", or how many there are where they are many.
std::string namesText(const std::vector<std::string>& names);

/// Returns what is compiled of blocks of one kind, which differ in nothing else: each text once.
std::string compiledText(const std::vector<const BlockUse*>& uses);

/// Holds the scene's lights. One is left out when it is switched off, cannot send anything, or,
/// with all of its group, ends before what is drawn. A drawing takes the key light of them alone,
/// unless the scene says otherwise.
struct LightsEffect {
    static constexpr bool isKnownToReference = true;

    std::vector<LightGroup> lights; ///< sorted by kind of light, then by compiled values
    std::uint64_t keyKind = 0;      ///< lightKey() of the key light; 0: no light shines
    bool drawingsTakeKey = true;    ///< as the scene says

    void choose(const SceneSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use);
    void addTo(ChoiceHash& hash) const;
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    void place(SceneLayout& layout, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    static bool dependsOnPlaces(const Scene& scene, const Catalog& catalog, std::string_view kind);
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const LightsEffect& a, const LightsEffect& b) {
        return a.lights == b.lights && a.keyKind == b.keyKind &&
               a.drawingsTakeKey == b.drawingsTakeKey;
    }

  private:
    LightLines lines_; ///< kept for its memory
};

/// Tells whether what is drawn is a drawing that takes the key light alone: of a scene without
/// lights the environment as one, and without that the ambient light.
bool takesKeyAlone(const EffectSet& set);

/// Tells whether the program has the lights of the group, or of a drawing's the key light.
bool isTaken(const EffectSet& set, const LightGroup& group);

/// Tells whether the program has the scene's ambient light and its hemisphere.
bool takesAmbient(const EffectSet& set);

/// "The material is a drawing and takes the key light, Key, alone.": why it takes no other.
std::string drawingText(const EffectSubject& subject);

/// Declares the functions of all groups of lights, and calls them with `model`.
void writeLights(SurfaceText& text);

} // namespace patina
