// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/display.h"

#include <cmath>

#include <fmt/format.h>

namespace patina {

void DisplayEffect::list(EffectListing& listing) const {
    if (isExposed) {
        listing.add("exposure", {}, [](const EffectSubject& subject) {
            const double stops = subject.scene.exposure;
            return fmt::format("Everything is {:.4g} stops {}.", std::abs(stops),
                               stops > 0.0 ? "brighter" : "darker");
        });
    }
    if (toneMapping != ToneMapping::None) {
        listing.add("tone mapping", {}, always("What is too bright for a display is compressed."));
    }
}

void DisplayEffect::listMissing(LeftOutListing& listing) const {
    if (!isExposed) {
        listing.add("exposure", "It is 0 stops.");
    }
    if (toneMapping == ToneMapping::None) {
        listing.add("tone mapping", "None is chosen.");
    }
}

void DisplayEffect::remove(Scene& scene, const EffectName& effect) {
    if (effect.kind == "exposure") {
        scene.exposure = 0.0;
    } else if (effect.kind == "tone mapping") {
        scene.toneMapping = ToneMapping::None;
    }
}

} // namespace patina
