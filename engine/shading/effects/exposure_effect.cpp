// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/exposure_effect.h"

#include <cmath>

#include <fmt/format.h>

namespace patina {
namespace {

constexpr const char* exposureName = "exposure";

} // namespace

void ExposureEffect::choose(const Scene& scene, const Catalog&) {
    isExposed = scene.exposure != 0.0;
}

void ExposureEffect::list(EffectListing& listing, const DisplaySet&) const {
    if (isExposed) {
        listing.add(exposureName, {}, [](const EffectSubject& subject) {
            const double stops = subject.scene.exposure;
            return fmt::format("Everything is {:.4g} stops {}.", std::abs(stops),
                               stops > 0.0 ? "brighter" : "darker");
        });
    }
}

void ExposureEffect::listMissing(LeftOutListing& listing, const DisplaySet&) const {
    if (!isExposed) {
        listing.add(exposureName, "It is 0 stops.");
    }
}

void ExposureEffect::write(SourceBuilder& fragment) const {
    fragment.addFile(isExposed ? "passes/exposed.glsl" : "passes/exposed_none.glsl");
}

void ExposureEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == exposureName) {
        scene.exposure = 0.0;
    }
}

} // namespace patina
