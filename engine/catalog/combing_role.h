// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina::roles {

/// Is where strands are combed to, along the object's axes. An image says it along the surface: red
/// along u and green along v, from -1 at 0 to 1 at 1.
inline constexpr std::string_view combing = "combing";

} // namespace patina::roles
