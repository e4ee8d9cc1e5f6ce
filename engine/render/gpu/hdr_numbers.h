// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Tells how fine the numbers of a linear picture are.
enum class HdrNumbers {
    Half, ///< 16 bits per channel: a rounding of 0.05 % that nobody sees
    Full, ///< 32 bits, where they are measured
};

} // namespace patina
