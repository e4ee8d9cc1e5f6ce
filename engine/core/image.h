// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace patina {

/// Holds pixels as linear floats, rows from the top, channels interleaved.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;          ///< 1, 3 or 4 (alpha is last and not premultiplied)
    std::vector<float> pixels; ///< width * height * channels

    friend bool operator==(const Image&, const Image&) = default;
};

} // namespace patina
