// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Describes a line from `from` to `to`, a filled rectangle with these corners, a dot or a ring at
/// `from`, or a text that begins there, in pixels from the top left.
struct PlotShape {
    enum class Kind { Line, Dashes, Rectangle, Dot, Ring, Text };

    Kind kind = Kind::Line;
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
    glm::dvec3 color{1.0}; ///< sRGB
    std::string text;

    friend bool operator==(const PlotShape&, const PlotShape&) = default;
};

/// Holds the colours that all drawings have in common, sRGB.
namespace plot_colors {
inline constexpr glm::dvec3 paper(0.11);
inline constexpr glm::dvec3 grid(0.26);
inline constexpr glm::dvec3 ink(0.85);
} // namespace plot_colors

/// Returns the drawing as the text of an SVG file, or as a picture with sRGB values, 0 .. 1.
std::string plotSvg(const std::vector<PlotShape>& shapes, glm::ivec2 size);
Image plotImage(const std::vector<PlotShape>& shapes, glm::ivec2 size);

/// Writes the drawing into a file: .svg, or else a picture.
Result<void> writeDrawing(const std::vector<PlotShape>& shapes, glm::ivec2 size,
                          const std::string& file);

} // namespace patina
