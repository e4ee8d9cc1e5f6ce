// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/cost_drawing.h"

namespace patina {

/// A point of a drawing that wants a name.
struct NamedPoint {
    glm::dvec2 at{0.0}; ///< pixels from the top left
    std::string name;
    bool isMain = false; ///< names the place where points lie upon each other
};

/// One text for each place ("exact and 4 more") that has room for one, beside its points and beside
/// each other, in a drawing of this size; the first points have the first choice. Where they can,
/// they keep clear of the middles of all marks.
std::vector<PlotShape> labelsOf(const std::vector<NamedPoint>& points,
                                const std::vector<glm::dvec2>& marks, glm::ivec2 size,
                                const glm::dvec3& color);

} // namespace patina
