// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_parts.h"
#include "shading/program/program_source.h"

namespace patina {

/// Holds the block that draws a material's outline, when it draws any line; else a null block and a
/// sentence why not.
struct OutlineChoice {
    const Block* block = nullptr;
    const char* whyNot = ""; ///< empty where the material has none at all
};
OutlineChoice outlineChoice(const Material& material, const Catalog& catalog);

/// Lines along the edges of the mesh, drawn by a program of its own.
struct OutlineEffect {
    std::optional<BlockUse> outline;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use) { admitTo(outline, kinds::outline, use); }
    void addTo(ChoiceHash& hash) const { hash.add(outline); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::outline), {}, "The material has no outline."};
    }
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const OutlineEffect&, const OutlineEffect&) = default;
};

/// Holds the array `objectData` of the program that draws outlines.
struct OutlineLayout {
    static constexpr int line = 0;  ///< x, y: a pixel of the picture in clip space; z: what nears a
                                    ///< point to the eye by as much as it is wide there
    static constexpr int fixed = 1; ///< the block's values follow

    BlockPlace block;

    int vec4s() const { return fixed + block.vec4s(); }
};

/// Points into the catalogue's block; nothing where the set has no outline.
std::optional<OutlineLayout> outlineLayout(const EffectSet& set);

/// Returns the program that draws the lines of a set with an outline. It reads edges (GpuEdges) and
/// knows of the scene only its fog.
Checked<ProgramSource> outlineProgram(const EffectSet& set, const Catalog& catalog,
                                      int sceneVec4s = SceneLayout::minCapacity);

} // namespace patina
