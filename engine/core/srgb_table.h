// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image.h"

namespace patina {

/// Holds the sRGB curve of 8-bit pictures as tables; it rounds exactly, in a few nanoseconds per
/// value.
class SrgbTable {
  public:
    SrgbTable();

    /// Returns the linear value of a code.
    float decoded(std::uint8_t code) const { return linear_[code]; }

    /// Returns the code whose encoded value is nearest; below 0 and NaN give 0, above 1 gives 255.
    std::uint8_t encoded(float linear) const;

    /// Returns the first `channels` channels of the image as 8-bit codes (grey is repeated); alpha,
    /// the fourth, stays linear.
    std::vector<std::uint8_t> codes(const Image& image, int channels) const;

  private:
    static constexpr int slots = 4096;

    std::array<float, 256> linear_{};
    std::array<float, 256> upper_{}; ///< holds the first linear value above each code's range
    /// Holds the code at the start of each 1/slots of [0, 1).
    std::array<std::uint8_t, slots> first_{};
};

} // namespace patina
