// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Tells whether an object is drawn and transparent; how many of a scene's are.
bool isVisiblyTransparent(const Object& object, const Catalog& catalog);
int countTransparent(const Scene& scene, const Catalog& catalog);

/// Tells whether what is drawn with the set may be transparent.
bool isVisiblyTransparent(const EffectSet& set);

/// Returns the block that puts together what is transparent; null where nothing is, or each object
/// is blended by itself.
const Block* transparencyBlock(const Scene& scene, const Catalog& catalog);

/// Says how what is transparent is put together, in the programs that draw it; without a block each
/// object is blended over what is behind it.
struct TransparencyEffect {
    static constexpr bool isKnownToReference = true;

    std::optional<BlockUse> transparency;

    void choose(const SceneSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use) { admitTo(transparency, kinds::transparency, use); }
    void addTo(ChoiceHash& hash) const { hash.add(transparency); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet& set) const;
    void place(ObjectLayout& layout, const EffectSet& set) const;
    void write(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const TransparencyEffect&, const TransparencyEffect&) = default;
};

} // namespace patina
