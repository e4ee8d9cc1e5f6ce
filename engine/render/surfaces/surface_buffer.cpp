// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/surface_buffer.h"

namespace patina {

std::optional<std::size_t> SurfaceBuffer::objectAt(std::size_t pixel) const {
    const auto number = static_cast<std::size_t>(positions[pixel].w);
    return number == 0 ? std::nullopt : std::optional(number - 1);
}

glm::dvec2 SurfaceBuffer::place(std::size_t pixel) const {
    const auto columns = static_cast<std::size_t>(size.x);
    const std::size_t row = pixel / columns;
    return {double(pixel % columns) + 0.5, double(size.y) - double(row) - 0.5};
}

} // namespace patina
