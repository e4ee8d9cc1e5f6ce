// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"

namespace patina {

/// What bends the light that a material lets through; a null block: nothing does, and why.
struct RefractionChoice {
    const Block* block = nullptr;
    const Values* values = nullptr;
    const char* whyNot = ""; ///< empty where the material chooses nothing
};

/// A neutral choice is left out: where nothing passes, and where the index is 1 and nothing is
/// coloured. Allocates nothing.
RefractionChoice refractionChoice(const Material& material, const Catalog& catalog);

/// The index of the body relative to what surrounds it: the block's own `index`, or, where its
/// `index.from` does not say "own", that of the material's Fresnel term (`index.inside` over
/// `index.outside`, or sqrt(f0) = (n - 1) / (n + 1) for the mean of `f0`), or the model's `index`.
/// 0.1 .. 10.
double bodyIndex(const Material& material, const RefractionChoice& choice, const Catalog& catalog);

/// Whether light leaves it in its old direction: a pane, which has a `thickness`.
bool isSheet(const Block& refraction);

/// Whether an object that is seen bends what is behind it. Allocates nothing.
bool hasRefraction(const Scene& scene, const Catalog& catalog);

/// Whether an object bends what is behind it and there is something of the scene to be behind it.
bool showsSceneRefracted(const Scene& scene, const Catalog& catalog);

} // namespace patina
