// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "measure/approximation/half_terms.h"
#include "measure/time/median_interval.h"

namespace patina {

/// Holds what a block takes on a device with some of its lines in floats of 16 bits.
struct HalfTiming {
    std::string extension;         ///< is what the device's types of 16 bits come from
    bool hasFunctions = true;      ///< says that pow() and the like are computed in 16 bits as well
    MedianInterval ratio;          ///< of the time in 16 bits to that in floats
    MedianInterval milliseconds;   ///< of the draws in floats
    double halfMilliseconds = 0.0; ///< is the median of the draws with 16 bits
    int pairs = 0;
    std::string method; ///< is FrameTimer's
};

/// Draws a block's function over and over, in floats and with the lines of the report in 16 bits,
/// in turn, and times both. Its context must be current. It is an error where the device has no
/// types of 16 bits, with what its compiler says of each extension.
Result<HalfTiming> halfTiming(const EvalCase& subject, const HalfReport& report,
                              const std::vector<std::size_t>& lines);

} // namespace patina
