// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/plot_shapes.h"

namespace patina {

/// Holds a point of a drawing that gets a label.
struct NamedPoint {
    glm::dvec2 at{0.0}; ///< pixels from the top left
    std::string name;
    bool isMain = false; ///< its name is the one that is shown where points coincide
};

/// Returns one text for each place ("exact and 4 more") that has room for one, beside its points
/// and without overlap, in a drawing of this size in pixels; the first points choose first. Where
/// possible the texts stay clear of the marks.
std::vector<PlotShape> labelsOf(const std::vector<NamedPoint>& points,
                                const std::vector<glm::dvec2>& marks, glm::ivec2 size,
                                const glm::dvec3& color);

} // namespace patina
