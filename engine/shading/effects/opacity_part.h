// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"

namespace patina {

/// Holds what of a set decides where a surface is there at all, for programs that draw no colours:
/// its opacity, and the image that changes it. The data of the whole program serve these too.
struct OpacityPart {
    EffectSet set;
    ObjectLayout layout;
    std::optional<std::size_t> image; ///< the index of that image in the whole set

    bool hasImage() const { return image.has_value(); }
};

OpacityPart opacityPart(const EffectSet& set, const ObjectLayout& layout);

} // namespace patina
