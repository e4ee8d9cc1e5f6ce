// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/image.h"
#include "measure/cost/cost_chart.h"

namespace patina {

/// Describes a line from `from` to `to`, a dot or a ring at `from`, or a text that begins there, in
/// pixels from the top left.
struct PlotShape {
    enum class Kind { Line, Dot, Ring, Text };

    Kind kind = Kind::Line;
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
    glm::dvec3 color{1.0}; ///< sRGB
    std::string text;

    friend bool operator==(const PlotShape&, const PlotShape&) = default;
};

/// Returns the chart as a drawing of `size` pixels: the time to the right, the error upwards, both
/// on logarithmic scales. Bars show how sure the times are, a line shows the front, and rings mark
/// what may be on it within the noise.
std::vector<PlotShape> costPlot(const CostChart& chart, glm::ivec2 size);

/// Returns the drawing as the text of an SVG file, or as a picture with sRGB values, 0 .. 1.
std::string plotSvg(const std::vector<PlotShape>& shapes, glm::ivec2 size);
Image plotImage(const std::vector<PlotShape>& shapes, glm::ivec2 size);

} // namespace patina
