// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "measure/lobe/lobe_model.h"

namespace patina {

/// Names the two numbers that a table is over, the viewer's to the right and the light's down.
enum class TableAxes {
    NormalCosines, ///< n.v and n.l, 0 .. 1
    TangentCosines ///< v.t and l.t, -1 .. 1
};

/// Is a reflectance that two numbers decide, at the middles of size x size texels.
struct ReflectanceTable {
    TableAxes axes = TableAxes::NormalCosines;
    /// Says that values are pi f n.l, else pi f: whichever loses less by the table.
    bool hasCosine = false;
    double tangentDegrees = 0.0; ///< is how far t is turned from the surface's tangent
    int size = 0;
    std::vector<glm::dvec3> values; ///< are rows of one light, the least number first

    // What is lost by linear interpolation, of pi f n.l, for which white facing the light is 1. It
    // is most where both directions graze the surface, and measured down to 0.001 of the axes.
    double maxError = 0.0;
    double meanError = 0.0;

    /// Returns what a linear filter that clamps to the edge reads for the two numbers.
    glm::dvec3 read(double light, double viewer) const;
    /// Returns pi f n.l by the table, for unit directions above the surface.
    glm::dvec3 value(const glm::dvec3& l, const glm::dvec3& v) const;
};

/// Returns the table of a material's model, or of a term. Which two numbers decide is found by the
/// model's values at many directions; it is an error where neither pair does.
Result<ReflectanceTable> reflectanceTable(const Catalog& catalog, const Material& material,
                                          LobeTerm term, int size);

/// Says in a line what the table is over and how far it is off.
std::string tableText(const ReflectanceTable& table);

} // namespace patina
