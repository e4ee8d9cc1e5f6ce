// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image_places.h"

#include <algorithm>
#include <cstddef>

namespace patina {
namespace {

/// Limits how many vertices are compared: more would take a window's time.
constexpr std::size_t maxVertices = std::size_t(1) << 20;

} // namespace

bool hasImagePlaces(std::span<const Vertex> vertices) {
    const std::size_t step = std::max<std::size_t>(vertices.size() / maxVertices, 1);
    for (std::size_t i = 0; i < vertices.size(); i += step) {
        if (vertices[i].uv != vertices.front().uv) {
            return true;
        }
    }
    return false;
}

} // namespace patina
