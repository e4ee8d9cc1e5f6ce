// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds the block of strands that grow on a material's surface; else a null block and a sentence
/// why there are none.
struct ShellsChoice {
    const Block* block = nullptr;
    const Values* values = nullptr;
    const char* whyNot = ""; ///< empty where the material has no such block
};

/// Strands without length or density are left out, and those of transparent materials. Allocates
/// nothing.
ShellsChoice shellsChoice(const Material& material, const Catalog& catalog);

/// Returns how far a material's strands reach from its surface, in metres; 0 without any.
double shellsLength(const Material& material, const Catalog& catalog);

/// Returns how many layers cut the strands, by the block's accuracy choice with whole numbers for
/// levels; 16 where it has none. At least 1.
int shellLayers(const BlockUse& shells);

/// Returns how many layers of strands a material has over its surface; 0 without any.
int layersOver(const Material& material, const Catalog& catalog);

/// Strands of fur or grass on the surface, drawn as instances of the mesh: the skin and a layer
/// for each step of their length (J. Lengyel et al., I3D 2001).
struct ShellsEffect {
    std::optional<BlockUse> shells;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use) { admitTo(shells, kinds::shells, use); }
    void addTo(ChoiceHash& hash) const { hash.add(shells); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::shells), {}, "Nothing grows on the material."};
    }
    void place(ObjectLayout& layout, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    std::string_view whyPerPixel(const EffectSet&) const {
        return shells ? "strands differ from pixel to pixel." : std::string_view();
    }
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const ShellsEffect&, const ShellsEffect&) = default;
};

/// Returns how many instances of its mesh draw an object with such a program: the skin and its
/// layers.
int instancesOf(const EffectSet& set);

/// Writes what finds the strand of a fragment, and the statements at the beginning of main.
void writeShells(SurfaceText& text);

/// Writes what moves the vertices of a layer, or those of fins; returns the statement of main.
std::string writeShellsVertex(SurfaceText& text);

/// Tells whether the strands are lit by their block in place of the model.
bool lightsStrands(const BlockUse& shells);

/// Tells whether strands also stand on the edges of the mesh along silhouettes.
bool hasFins(const BlockUse& shells);

/// Tells the same of a material.
bool hasFins(const Material& material, const Catalog& catalog);

} // namespace patina
