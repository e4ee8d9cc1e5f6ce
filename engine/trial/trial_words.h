// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Names the command by which the program tries blocks. No help lists it, since nobody types it.
inline constexpr const char* trialCommandWord = "try-blocks";

} // namespace patina
