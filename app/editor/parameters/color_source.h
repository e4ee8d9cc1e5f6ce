// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

namespace patina {

/// Is the interface of widgets that know the colours they show more exactly than the screen does.
class ColorSource {
  public:
    virtual ~ColorSource() = default;

    /// Returns what the widget shows as linear light, at the screen's own resolution; empty when
    /// there is nothing.
    virtual Image linearPicture() = 0;
};

} // namespace patina
