// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds what happens to the picture after the objects are drawn. It is in no program of theirs, so
/// it is not in EffectSet.
struct DisplayEffect {
    bool isExposed = false;
    ToneMapping toneMapping = ToneMapping::None;

    explicit DisplayEffect(const Scene& scene)
        : isExposed(scene.exposure != 0.0), toneMapping(scene.toneMapping) {}

    /// Differs where other programs do it.
    std::uint64_t key() const {
        return 2 * static_cast<std::uint64_t>(toneMapping) + (isExposed ? 1 : 0);
    }

    void list(EffectListing& listing) const;
    void listMissing(LeftOutListing& listing) const;
    static void remove(Scene& scene, const EffectName& effect);
};

} // namespace patina
