// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina::roles {

/// Are set at each pixel of a picture, for models that draw on the surface, beside those of the
/// place: how the unit normal changes by the place, in 1/m along the object's axes: the xx, yy and
/// zz of a symmetric matrix, and its xy, yz and zx.
inline constexpr std::string_view placeCurvature = "placeCurvature";
inline constexpr std::string_view placeCurvatureMixed = "placeCurvatureMixed";

} // namespace patina::roles
