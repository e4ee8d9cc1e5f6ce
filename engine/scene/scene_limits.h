// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_text.h"

namespace patina {

/// A scene holds the whole material of each of its objects: some two kilobytes for each.
inline constexpr JsonLimits sceneLimits{.bytes = std::size_t(256) << 20};

} // namespace patina
