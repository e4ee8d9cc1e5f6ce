// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/image.h"

namespace patina {

/// Returns the exposure, in powers of two from -32 to 32, with which the mean brightness of a
/// picture is middle grey, 0.18: the mean of the logarithms of its luminances (E. Reinhard et al.,
/// Photographic Tone Reproduction for Digital Images, SIGGRAPH 2002, eq. 1), rounded to 0.01. The
/// picture is linear light, without an exposure. Pixels that are black, infinite or NaN do not
/// count; the result is empty where no pixel counts.
std::optional<double> autoExposure(const Image& linear);

} // namespace patina
