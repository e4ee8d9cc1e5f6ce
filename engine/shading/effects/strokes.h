// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds the block of marks that are set on a material's surface; else a null block and a sentence
/// why there are none.
struct StrokesChoice {
    const Block* block = nullptr;
    const Values* values = nullptr;
    const char* whyNot = ""; ///< empty where the material has no such block
};

/// Marks without density, length or width are left out, and those of transparent materials and
/// under fur. Allocates nothing.
StrokesChoice strokesChoice(const Material& material, const Catalog& catalog);

/// Returns how many marks of a material stand on a square of a unit's width, of which the picture
/// is 512 high; 0 without any. So few remain that a place lies under no more than 32 of them.
double marksPerUnit(const Material& material, const Catalog& catalog);

/// Returns the share of the marks that are drawn, by the block's accuracy choice with whole numbers
/// of percent for levels; 1 where it has none.
double shareOfMarks(const BlockUse& strokes);

/// Marks of a brush or a pen on fixed points of the surface, each in the light of its point
/// (B. Meier, Painterly Rendering for Animation, SIGGRAPH 1996).
struct StrokesEffect {
    std::optional<BlockUse> strokes;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use) { admitTo(strokes, kinds::strokes, use); }
    void addTo(ChoiceHash& hash) const { hash.add(strokes); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::strokes), {}, "The material has no strokes."};
    }
    void place(ObjectLayout& layout, const EffectSet& set) const;
    void write(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const StrokesEffect&, const StrokesEffect&) = default;
};

/// Writes the marks' declarations and the statements at the beginning of main, which leave out what
/// lies beside a mark.
void writeMarks(SurfaceText& text);

/// Writes what makes quads of marks; returns the statement of main.
std::string writeMarksVertex(SurfaceText& text);

/// Tells whether marks hide each other by their depth, as things that stand on the surface; else
/// they lie over each other like paint, in an order that never changes.
bool areStanding(const BlockUse& strokes);

} // namespace patina
