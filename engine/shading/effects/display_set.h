// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shading/effects/effect_choices.h"
#include "shading/effects/exposure_effect.h"
#include "shading/effects/passes_effect.h"
#include "shading/effects/tone_effect.h"
#include "shading/program/program_source.h"

namespace patina {

/// Lists every effect of what shows a picture, in the order of their rows. A new
/// one is a row here.
using AllDisplayEffects = EffectChoices<ExposureEffect, ToneEffect, PassesEffect>;

/// Says exactly what happens to a picture after the objects are drawn: the choices of all effects
/// of the display. It points into the catalogue that it was made with.
struct DisplaySet : AllDisplayEffects {
    friend bool operator==(const DisplaySet&, const DisplaySet&) = default;
};

/// Returns what showing a picture of the scene calls for. Allocates nothing.
DisplaySet displaySet(const Scene& scene, const Catalog& catalog);

/// Differs where the choices do. Allocates nothing.
std::uint64_t keyOf(const DisplaySet& set);

/// Returns the program that shows linear light: exposure where there is any (`exposureFactor`), the
/// curve with its values (`toneData`) and sRGB.
Checked<ProgramSource> displayProgram(const DisplaySet& set, const Catalog& catalog);

} // namespace patina
