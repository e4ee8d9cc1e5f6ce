// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/slots.h"

#include <algorithm>

#include <fmt/format.h>

#include "material/model_swap.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/light_colors.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/spectral_range.h"
#include "shading/effects/surface_text.h"
#include "shading/program/block_source.h"

namespace patina {
namespace {

bool isNeutral(const SlotChoice& choice, const Material& material) {
    return choice.block != nullptr && isNeutralPart(*choice.block, *choice.values, material);
}

/// Lists a sentence about the slot of a kind that no block of the id fills.
void listUnknown(LeftOutListing& listing, const Slot& slot, const std::string& id) {
    listing.add(slot.kind, fmt::format("No block \"{}\" is known for the model's slot.", id));
}

void listMissingBlock(LeftOutListing& listing, const Slot& slot, const Material& material) {
    const SlotChoice choice = slotChoice(slot, material, listing.subject().catalog);
    const BlockValues* part = material.part(slot.kind);
    if (part != nullptr && !choice.chosen) {
        listUnknown(listing, slot, part->id);
    }
    if (isNeutral(choice, material)) {
        listing.add(slot.kind + '/' + choice.block->id,
                    whyNeutral(*choice.block, *choice.values, material.accuracy));
    } else if (choice.block == nullptr && !slot.defaultBlock.empty()) {
        listUnknown(listing, slot, slot.defaultBlock);
    }
}

} // namespace

SlotChoice slotChoice(const Slot& slot, const Material& material, const Catalog& catalog) {
    static const Values none;
    const BlockValues* part = material.part(slot.kind);
    const Block* chosen = part == nullptr ? nullptr : catalog.find(slot.kind, part->id);
    if (chosen != nullptr) {
        return {chosen, &part->parameters, true};
    }
    return {slot.defaultBlock.empty() ? nullptr : catalog.find(slot.kind, slot.defaultBlock), &none,
            false};
}

bool areSlotsFilled(const Block& model, const MaterialSubject& subject) {
    return std::ranges::all_of(model.slots, [&subject](const Slot& slot) {
        return slot.defaultBlock.empty() ||
               slotChoice(slot, subject.material, subject.catalog).block != nullptr;
    });
}

void SlotsEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    slots.clear();
    if (!set.model) {
        return;
    }
    for (const Slot& slot : set.model->block().slots) {
        const SlotChoice choice = slotChoice(slot, subject.material, subject.catalog);
        if (choice.block != nullptr && !isNeutral(choice, subject.material)) {
            slots.emplace_back(*choice.block, *choice.values, subject.material.accuracy);
        }
    }
}

void SlotsEffect::adjust(const EffectSet& set) {
    for (BlockUse& slot : slots) {
        makeTexturedExact(slot, set);
    }
}

void SlotsEffect::addTo(ChoiceHash& hash) const {
    hash.add(std::uint64_t(slots.size()));
    for (const BlockUse& slot : slots) {
        hash.add(slot);
    }
}

void SlotsEffect::list(EffectListing& listing, const EffectSet& set) const {
    for (const BlockUse& slot : slots) {
        listing.add(slot, [&slot, &set](const EffectSubject& subject) -> std::string {
            const BlockValues* part = subject.material->part(slot.block().kind);
            const std::string why =
                part != nullptr && part->id == slot.block().id
                    ? "The material chooses it for the model." +
                          spectralRangeNote(slot.block(), part->parameters, subject.scene)
                    : "The model needs one and the material chooses none.";
            return why + polarisationNote(set, slot.block());
        });
    }
}

/// Lists what the material chooses and the model does not call, too, but for what blends the sum.
void SlotsEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    const Material* material = listing.subject().material;
    const Block* model = material == nullptr
                             ? nullptr
                             : listing.subject().catalog.find(kinds::models, material->model.id);
    if (model == nullptr) {
        return;
    }
    for (const Slot& slot : model->slots) {
        listMissingBlock(listing, slot, *material);
    }
    for (const auto& [kind, values] : material->parts) {
        if (set.model && !hasPlaceFor(*model, kind)) {
            listing.add(kind + '/' + values.id, "The model has no slot for it.");
        }
    }
}

void SlotsEffect::place(ObjectLayout& layout, const EffectSet&) const {
    for (const BlockUse& slot : slots) {
        layout.slots.push_back(placed(slot, layout.vec4s));
        layout.tables.add(layout.slots.back(), slot, TableReader::Slot);
    }
}

void writeSlots(SurfaceText& text) {
    for (std::size_t i = 0; i < text.set.slots.size(); ++i) {
        const BlockUse& use = text.set.slots[i];
        const std::string& kind = use.block().kind;
        text.addBlock(use.block());
        text.out.add(slotNamesSource(use.block()));
        if (kind == kinds::fresnel && answersPolarisedLight(text.set)) {
            writePolarisedFresnel(text, use.block());
        }
        text.addUnpack(use, "unpack" + slotStructName(kind));
        text.filled.push_back({kind, text.object.slots[i].vec4s()});
    }
    for (const Slot& slot : text.set.model->block().slots) {
        if (std::ranges::none_of(
                text.filled, [&slot](const SlotFill& fill) { return fill.kind == slot.kind; })) {
            text.out.add(emptySlotSource(slot.kind));
        }
    }
}

void SlotsEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::specular) {
        removePart(scene, effect);
    }
}

void removePart(Scene& scene, const EffectName& effect) {
    for (Object& object : scene.objects) {
        const BlockValues* part = object.material.part(effect.kind);
        if (part != nullptr && part->id == effect.id) {
            object.material.parts.erase(object.material.parts.find(effect.kind));
        }
    }
}

} // namespace patina
