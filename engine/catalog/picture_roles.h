// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina::roles {

/// Are the state of a picture pass: how what it returns and the picture before it are put together
/// ("replace", "over", "multiply", "screen" or "add"), how much of that counts, from 0 to 1, and
/// where it works at all, by the depths that were drawn ("everywhere", "surfaces" or "background").
inline constexpr std::string_view blend = "blend";
inline constexpr std::string_view blendAmount = "blendAmount";
inline constexpr std::string_view depthTest = "depthTest";

/// Is the image whose brightness is a pass's thresholds.
inline constexpr std::string_view threshold = "threshold";

/// Are a pass's choices that compute the same look more cheaply, of which the last is exact. They
/// are on the chart of the scene's picture.
inline constexpr std::string_view accuracy = "accuracy";

} // namespace patina::roles
