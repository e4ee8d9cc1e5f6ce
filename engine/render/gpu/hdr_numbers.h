// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Says how precise the numbers of a linear picture are.
enum class HdrNumbers {
    Half, ///< has 16 bits per channel, whose rounding of 0.05 % is invisible
    Full, ///< has 32 bits per channel, for pictures that are measured
};

} // namespace patina
