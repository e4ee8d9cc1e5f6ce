// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "material/material.h"
#include "scene/scene.h"
#include "shading/effects/effect_view.h"

namespace patina {

/// The value a parameter has: the given one where it is there and of the right type, else the
/// default. Points into one of the arguments.
const Value& givenValue(const Parameter& parameter, const Values& values);

/// Whether no part of a number, a vector or a colour is above 0.
bool notPositive(const Value& value);

/// Index of the chosen enum value or accuracy level; 0 where the choice is not known.
std::size_t chosenIndex(const Parameter& parameter, const Values& values);
std::size_t chosenIndex(const AccuracyChoice& choice, const AccuracyLevels& levels);

/// True when the parameter is a number that is 0, or a vector or colour without a positive part.
bool isZero(const Parameter& parameter, const Values& values);

/// What a compiled parameter contributes to the program, as a small number: the state of its value,
/// or whether a float is zero or the same as another one of its block.
std::size_t compiledState(const Block& block, const Parameter& parameter, const Values& values);

/// Whether a light can send anything, and whether the scene's fog can change what is drawn.
bool canShine(const Light& light, const Block& block);
bool canHide(const Scene& scene, const Block& block, const EffectView& view);

/// Whether the scene has an ambient colour that is not black.
bool hasAmbient(const Scene& scene);

/// The share of the light that the material's model itself says to pass, 0 .. 1: by its parameters
/// with the key `transparency`. 0 where it has none or is not known.
double saidShare(const Material& material, const Catalog& catalog);

/// The share that is taken to pass, at most 1 - 2^-10: what the surface still gives back is divided
/// by the rest (see ObjectLayout::surface).
double passedShare(const Material& material, const Catalog& catalog);

/// How much of what is behind the material it hides, 0 .. 1: its opacity and its model's share
/// together.
double opacityOf(const Material& material, const Catalog& catalog);

/// Whether the material hides enough to keep light from others: half of it.
bool canShadow(const Material& material, const Catalog& catalog);

/// Whether an object keeps light from others: it is drawn, may do so, and lets less than half of
/// the light through.
bool isCaster(const Object& object, const Catalog& catalog);
bool hasCaster(const Scene& scene, const Catalog& catalog);

/// Whether a shadow can fall on anything: on the ground, or on an object whose model is known.
bool hasReceiver(const Scene& scene, const Catalog& catalog);

/// Whether the scene is one object that is flat: it keeps no light from itself.
bool isLoneFlat(const Scene& scene, const Catalog& catalog);

/// Whether shadows can be seen in lights that have some: something casts one, something catches it.
bool hasShadows(const Scene& scene, const Catalog& catalog);

/// The block that draws the shadows in a light of kind `light`; null where it has none.
const Block* shadowBlock(const Light& light, const Block& block, const Catalog& catalog);

/// Whether something shines through an object that is drawn; how many of a scene's there are.
bool isVisiblyTransparent(const Object& object, const Catalog& catalog);
int countTransparent(const Scene& scene, const Catalog& catalog);

/// The block that puts together what shines through; null where nothing does, or each object is
/// blended by itself.
const Block* transparencyBlock(const Scene& scene, const Catalog& catalog);

/// Whether the sky or the ground of the ambient hemisphere sends light.
bool hasHemisphere(const Scene& scene);

/// What an environment is made of, when it sends light or an object bends what is behind it, which
/// shows a dark one as well; else a null block and a sentence why not.
struct EnvironmentChoice {
    const Block* block = nullptr;
    const char* whyNot = ""; ///< empty where there is no environment at all
};
EnvironmentChoice environmentChoice(const Scene& scene, const Catalog& catalog);

/// Whether the model calls a Fresnel block itself; else one blends the sum, see EffectSet.
bool hasFresnelSlot(const Block& model);

/// The block that fills a model's slot, and its values: the material's part of that kind, else the
/// slot's default with its own defaults. A null block: the slot stays empty.
struct SlotChoice {
    const Block* block = nullptr;
    const Values* values = nullptr;
    bool chosen = false; ///< by the material
};
SlotChoice slotChoice(const Slot& slot, const Material& material, const Catalog& catalog);

/// Whether what fills a slot is always 0, as a slot that stays empty is.
bool isNeutral(const SlotChoice& choice, const Material& material);

/// The block that draws a material's outline, when it draws any line; else a null block and a
/// sentence why not.
struct OutlineChoice {
    const Block* block = nullptr;
    const char* whyNot = ""; ///< empty where the material has none at all
};
OutlineChoice outlineChoice(const Material& material, const Catalog& catalog);

/// Whether the block's parameter is a colour that is emitted and not black.
bool isEmitted(const Parameter& parameter, const Values& values);

} // namespace patina
