// SPDX-License-Identifier: GPL-3.0-or-later
// What an effect may be made of. Its type has members for what was chosen, which EffectSet has from
// it, and those of these functions that it needs (each finds the ones that are there):
//
//   void choose(const MaterialSubject& | const SceneSubject&, const EffectSet&): what is in; of the
//       set the effects before this one are chosen already. It fills what it has anew and allocates
//       nothing, since keys are made so in every frame.
//   void admit(const BlockUse&): a block of its kind is in whatever the subject calls for: it is
//       tried.
//   void adjust(const EffectSet&): what follows from the choices of others.
//   void addTo(ChoiceHash&) const: its share of EffectKey::ofMaterial() or ofScene(), by the
//       subject of its choose().
//   void list(EffectListing&, const EffectSet&) const: its rows, with reasons.
//   void listMissing(LeftOutListing&, const EffectSet&) const: what the document has of it and the
//       program does not, and why.
//   EffectLine absent(const EffectSet&) const: what is said where the document has none of it.
//   void place(ObjectLayout& | SceneLayout&, const EffectSet&) const: where its data lie.
//   void writeLight(SurfaceText&) const: what lights a surface.
//   void write(SurfaceText&) const: what becomes of that light.
//   std::string writeVertex(SourceBuilder&) const: declares what the vertices hand on, and returns
//       the statements of their main that work it out.
//   std::string_view whyPerPixel(const EffectSet&) const: why it keeps light from being worked out
//       at vertices; empty: it does not.
//   int bufferValues() const, void writeBuffer(SurfaceText&, std::size_t place) const: how many
//       values a surface buffer has of it, and what stores them from that place on.
//   static bool dependsOnPlaces(const Scene&, const Catalog&, std::string_view kind): whether the
//       choice depends on where things are, which values of this kind of block or settings move.
//   static constexpr bool isKnownToReference: the frame in double precision (SurfaceCode of
//       measure/error) does the same to a surface, or refuses one that has it. A surface with
//       an effect that writes and does not say so has no such frame.
//   static void remove(Scene&, const EffectName&, const Catalog&): the scene without it, where the
//       name is its own.
#pragma once

#include <optional>
#include <string_view>

#include "shading/effects/choice_hash.h"
#include "shading/effects/effect_listing.h"
#include "shading/effects/effect_subject.h"
#include "shading/program/block_use.h"

namespace patina {

struct EffectSet;
struct ObjectLayout;
struct SceneLayout;
class SurfaceText;

/// Chooses a block where it is of the kind.
inline void admitTo(std::optional<BlockUse>& choice, std::string_view kind, const BlockUse& use) {
    if (use.block().kind == kind) {
        choice = use;
    }
}

/// Holds what is taken out: "lights/<id>" has a kind and an id, "ambient" only the first.
struct EffectName {
    std::string_view kind;
    std::string_view id;
};

} // namespace patina
