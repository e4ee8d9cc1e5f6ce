// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Is the command by which the program tries blocks. It is in no help: nobody types it.
inline constexpr const char* trialCommandWord = "try-blocks";

} // namespace patina
