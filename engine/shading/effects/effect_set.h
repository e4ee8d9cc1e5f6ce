// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shading/effects/ambient.h"
#include "shading/effects/blend.h"
#include "shading/effects/drawn_place.h"
#include "shading/effects/effect_choices.h"
#include "shading/effects/effect_parts.h"
#include "shading/effects/emission.h"
#include "shading/effects/environment_effect.h"
#include "shading/effects/fog.h"
#include "shading/effects/ground_effect.h"
#include "shading/effects/hemisphere.h"
#include "shading/effects/highlight_ambient.h"
#include "shading/effects/lights.h"
#include "shading/effects/model.h"
#include "shading/effects/occlusion.h"
#include "shading/effects/opacity.h"
#include "shading/effects/outline.h"
#include "shading/effects/picture_effect.h"
#include "shading/effects/refraction.h"
#include "shading/effects/shadows.h"
#include "shading/effects/shells.h"
#include "shading/effects/slots.h"
#include "shading/effects/strokes.h"
#include "shading/effects/textures.h"
#include "shading/effects/transparency_effect.h"

namespace patina {

/// Lists every effect, in the order in which a program's text is assembled, which is that of
/// its rows. A new one is a row here.
using AllEffects =
    EffectChoices<GroundEffect, ModelEffect, SlotsEffect, DrawnPlaceEffect, ShellsEffect,
                  LightsEffect, ShadowsEffect, OcclusionEffect, AmbientEffect, HemisphereEffect,
                  HighlightAmbientEffect, EnvironmentEffect, BlendEffect, EmissionEffect,
                  TexturesEffect, StrokesEffect, FogEffect, OpacityEffect, RefractionEffect,
                  RefractedSceneEffect, TransparencyEffect, OutlineEffect, PictureEffect>;

/// Says exactly what one program computes: the choices of all effects. Equal sets give equal
/// program text. It points into the catalogue that it was made with.
struct EffectSet : AllEffects {
    friend bool operator==(const EffectSet&, const EffectSet&) = default;
};

/// Chooses what the material calls for, or what the scene does, and leaves the rest of the set
/// alone. Allocates nothing where the set has had as many lights before.
void chooseEffects(EffectSet& set, const MaterialSubject& subject);
void chooseEffects(EffectSet& set, const SceneSubject& subject);

/// Returns what the scene brings into every program that is used in it, and nothing of any
/// material.
EffectSet sceneEffects(const Scene& scene, const Catalog& catalog, const EffectView& view = {});

/// Returns what shading `material` in the scene calls for. A pure function of its arguments.
EffectSet effectSet(const Material& material, const Scene& scene, const Catalog& catalog,
                    const EffectView& view = {});

/// Returns what drawing the scene's ground calls for; its `ground` is Off when there is nothing to
/// draw.
EffectSet groundEffects(const Scene& scene, const Catalog& catalog, const EffectView& view = {});

/// Tells whether the program asks what lights the surface: the fallback for a model knows no light.
bool isLit(const EffectSet& set);

/// Tells whether an effect's choice depends on where things are, which values of this kind of block
/// or settings move.
bool dependsOnPlaces(const Scene& scene, const Catalog& catalog, std::string_view kind);

/// Returns what is in the program, in its order: names and details, and reasons with a subject,
/// which is what the set was chosen for.
std::vector<EffectLine> effectLines(const EffectSet& set);
std::vector<EffectLine> effectLines(const EffectSet& set, const EffectSubject& subject);

/// Returns the name of an effect that changes what a surface looks like and that the frame in
/// double precision does not know (isKnownToReference); empty where there is none.
std::string unknownToReference(const EffectSet& set);

/// Returns what the document has and the program has not, and why.
std::vector<EffectLine> leftOut(const EffectSet& set, const EffectSubject& subject);

/// Returns the same, and what the document does not have at all.
std::vector<EffectLine> leftOutLines(const EffectSet& set, const EffectSubject& subject);

} // namespace patina
