// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/effect_parts.h"
#include "shading/program/program_source.h"

namespace patina {

/// Holds what happens to the picture after the objects are drawn. It is in no program of theirs, so
/// it is not in EffectSet.
struct DisplayEffect {
    bool isExposed = false;
    std::optional<BlockUse> tone; ///< the curve that brings light into a display's range

    DisplayEffect(const Scene& scene, const Catalog& catalog);

    /// Differs where other programs do it. Allocates nothing.
    std::uint64_t key() const;

    void list(EffectListing& listing) const;
    void listMissing(LeftOutListing& listing) const;
    static void remove(Scene& scene, const EffectName& effect);
};

/// The program that shows linear light: exposure where there is any (`exposureFactor`), the curve
/// with its values (`toneData`) and sRGB.
Checked<ProgramSource> displayProgram(const DisplayEffect& display, const Catalog& catalog);

} // namespace patina
