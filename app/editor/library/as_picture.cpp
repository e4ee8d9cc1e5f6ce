// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/as_picture.h"

#include <algorithm>
#include <cmath>

namespace patina {

QImage asPicture(const Image& image) {
    QImage picture(image.width, image.height, QImage::Format_RGB888);
    const auto byte = [&](int x, int y, int channel) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
        const auto at =
            (row + static_cast<std::size_t>(x)) * static_cast<std::size_t>(image.channels);
        const float value = image.pixels[at + static_cast<std::size_t>(channel)];
        return static_cast<int>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
    };
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            picture.setPixel(x, y, qRgb(byte(x, y, 0), byte(x, y, 1), byte(x, y, 2)));
        }
    }
    return picture;
}

} // namespace patina
