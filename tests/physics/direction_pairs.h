// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "physics_cases.h"

/// This file has the six pairs of directions for which tables were computed.
namespace patina::physics {

/// Is the tolerance of the tables, which have 15 digits of each value.
inline constexpr double relativeRounding = 2e-13;

inline reference::Geometry pairOfDirections(const std::string& name) {
    const auto pair = table("lobes.json")["directions"][name];
    return geometry(direction(pair["light"][0], pair["light"][1]),
                    direction(pair["viewer"][0], pair["viewer"][1]));
}

/// Compares `value` with the six numbers of a row.
template <class F>
void expectRow(const nlohmann::json& row, F&& value) {
    for (const auto& [name, expected] : row.items()) {
        const double number = expected;
        EXPECT_NEAR(value(pairOfDirections(name)), number,
                    relativeRounding * std::abs(number) + 1e-300)
            << "directions " << name;
    }
}

/// Returns the fields of Directions in their order.
inline std::vector<double> projections(const reference::Geometry& g) {
    std::vector<double> numbers;
    for (const glm::dvec3& u : {g.n, g.t, g.b, g.l, g.v}) {
        numbers.insert(numbers.end(), {u.x, u.y, u.z});
    }
    return call("directions", numbers);
}

enum Projection { nl, nv, nh, lh, lv, rv, lt, lb, vt, vb, ht, hb, sin2h, cos2h, HH, nH };

} // namespace patina::physics
