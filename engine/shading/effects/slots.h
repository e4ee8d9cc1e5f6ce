// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/container/small_vector.hpp>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds the block that fills a model's slot, and its values: the material's part of that kind,
/// else the slot's default with its own defaults. A null block: the slot stays empty.
struct SlotChoice {
    const Block* block = nullptr;
    const Values* values = nullptr;
    bool chosen = false; ///< by the material
};
SlotChoice slotChoice(const Slot& slot, const Material& material, const Catalog& catalog);

/// Tells whether every slot of the model that needs a block has one.
bool areSlotsFilled(const Block& model, const MaterialSubject& subject);

/// Holds what fills the model's slots, in the descriptor's order. A block that gives 0 everywhere
/// leaves its slot empty.
struct SlotsEffect {
    boost::container::small_vector<BlockUse, 2> slots;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void adjust(const EffectSet& set);
    void addTo(ChoiceHash& hash) const;
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    void place(ObjectLayout& layout, const EffectSet& set) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const SlotsEffect&, const SlotsEffect&) = default;
};

/// Declares what fills the slots, and stands for those that are empty, before the model.
void writeSlots(SurfaceText& text);

/// Takes the part that is named out of every material.
void removePart(Scene& scene, const EffectName& effect);

} // namespace patina
