// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "direction_pairs.h"

namespace patina::physics::ridges_test {
namespace {

/// How far two quadratures may differ.
constexpr double quadratureError = 1e-10;

const Subject& allReflected() {
    static const Subject subject = schlickFrom(1.0);
    return subject;
}

Values ridges(double spacing, double height, double shininess) {
    return {{"spacing", spacing}, {"height", height}, {"shininess", shininess}};
}

void expectPart(const std::string& row, const glm::dvec3& diffuse, const glm::dvec3& specular) {
    for (const auto& set : table("ridges.json")["sets"]) {
        Values values = ridges(set["spacing"], set["height"], set["shininess"]);
        values["diffuse.color"] = diffuse;
        values["specular.color"] = specular;
        values["normalisation"] = std::string(row == "raw" ? "raw" : "normalised");
        const Subject model("models", "poulin-fournier", values);
        for (const auto& [name, expected] : set[row].items()) {
            const double number = expected;
            EXPECT_NEAR(model.shade(pairOfDirections(name), allReflected().filler()).x, number,
                        quadratureError * number)
                << row << ' ' << name << " spacing " << set["spacing"];
        }
    }
}

TEST(PoulinFournier, MattePart_MatchesItsTable) {
    expectPart("matte", white, black);
}

TEST(PoulinFournier, BareHighlight_MatchesItsTable) {
    expectPart("raw", black, white);
}

TEST(PoulinFournier, HighlightOfTheSameEnergy_MatchesItsTable) {
    expectPart("normalised", black, white);
}

/// Whether the ray from p along w, both in the plane across the ridges, meets one of the cylinders
/// of radius 1 whose axes are `spacing` apart.
bool isBlocked(const glm::dvec2& p, const glm::dvec2& w, double spacing) {
    for (int k = -30; k <= 30; ++k) {
        const glm::dvec2 o{p.x - k * spacing, p.y};
        const double towards = o.x * w.x + o.y * w.y;
        const double outside = o.x * o.x + o.y * o.y - 1.0;
        const bool startsOnIt = std::abs(outside) < 1e-9;
        if (outside < -1e-9 || (startsOnIt && towards < 0.0) ||
            (!startsOnIt && towards < 0.0 && towards * towards > outside)) {
            return true;
        }
    }
    return false;
}

/// The white matte part by ray casting from many points of one period.
double castRays(const reference::Geometry& g, double spacing, double height) {
    constexpr int points = 4000;
    const glm::dvec2 l{g.l.y, g.l.z};
    const glm::dvec2 v{g.v.y, g.v.z};
    const double foot = std::sqrt(1.0 - height * height);
    double sum = 0.0;
    const auto add = [&](const glm::dvec2& p, const glm::dvec2& n, double share) {
        const double facing = (n.x * l.x + n.y * l.y);
        const double seen = (n.x * v.x + n.y * v.y);
        if (facing > 0.0 && seen > 0.0 && !isBlocked(p, l / std::hypot(l.x, l.y), spacing) &&
            !isBlocked(p, v / std::hypot(v.x, v.y), spacing)) {
            sum += facing * seen * share;
        }
    };
    const double end = std::acos(height);
    for (int i = 0; i < points; ++i) {
        const double u = (i + 0.5) / points;
        const double psi = end * (2.0 * u - 1.0);
        const glm::dvec2 n{std::sin(psi), std::cos(psi)};
        add(n, n, 2.0 * end / points);
        const double gap = spacing - 2.0 * foot;
        add({foot + gap * u, height}, {0.0, 1.0}, gap / points);
    }
    return sum / (spacing * v.y);
}

TEST(PoulinFournier, MattePart_AgreesWithCastRays) {
    for (const double height : {-0.6, 0.0, 0.7}) {
        Values values = ridges(3.0, height, 1.0);
        values["diffuse.color"] = white;
        values["specular.color"] = black;
        const Subject model("models", "poulin-fournier", values);
        for (const std::string name : {"A", "B", "C", "D", "E", "F"}) {
            const auto g = pairOfDirections(name);
            // Half a point at each end of an arc or strip.
            EXPECT_NEAR(model.shade(g).x, castRays(g, 3.0, height), 2e-3) << height << name;
        }
    }
}

TEST(PoulinFournier, SameEnergy_IsReciprocal) {
    const Subject model("models", "poulin-fournier", ridges(2.5, 0.2, 40.0));
    for (const std::string name : {"A", "B", "D", "E", "F"}) {
        const auto g = pairOfDirections(name);
        const double there = model.shade(g, allReflected().filler()).x / g.l.z;
        EXPECT_NEAR(there, model.shade(geometry(g.v, g.l), allReflected().filler()).x / g.v.z,
                    quadratureError * there);
    }
}

TEST(PoulinFournier, CoveredByItsFloor_IsLambertAndBlinnPhong) {
    const Subject flat(
        "models", "poulin-fournier",
        {{"diffuse.color", white}, {"height", 1.0}, {"normalisation", std::string("raw")}});
    const Subject blinn("models", "blinn-phong",
                        {{"diffuse.color", white}, {"specular.color", white}, {"shininess", 30.0}});
    const auto g = pairOfDirections("A");
    EXPECT_NEAR(flat.shade(g, allReflected().filler()).x, blinn.shade(g).x, 1e-14);
}

/// The quadrature of the shader against the exact one, in units of the whole lobe's integral. What
/// is lit and seen faces the half vector: |psi - h.x| < pi/2.
/// The shader's polynomial with one argument list.
double shaderRidgeLobe(const std::vector<double>& in) {
    double near = 0.0;
    for (const reference::Function& function : reference::elementaryPolynomials()) {
        if (function.name == "ridgeLobe") {
            function.call(in.data(), &near);
        }
    }
    return near;
}

TEST(Elementary, RidgeLobe_KeepsItsBound) {
    for (const double e : {0.0, 1.0, 20.0, 500.0, 1e5}) {
        const double whole = std::sqrt(2.0 * std::numbers::pi / (e + 1.0));
        for (double to = -1.5; to < 1.6; to += 0.1) {
            const std::vector<double> in{-1.4, to, 0.0, 0.1, 0.9, e, 1.4, 1.0, 1.57, 0.0};
            EXPECT_NEAR(shaderRidgeLobe(in), call("ridgeLobe", in)[0], 2e-6 * whole)
                << e << ' ' << to;
        }
    }
}

/// An arc that ends before the middle of the lobe has its slope alone, however weak.
TEST(Elementary, RidgeLobesSlope_KeepsItsDigits) {
    for (const double e : {1.0, 20.0, 100.0, 1000.0}) {
        for (double to = -0.3; to < -0.01; to += 0.05) {
            const std::vector<double> in{-1.4, to, 0.0, 0.0, 1.0, e, 1.45, 1.0, 1.57, 0.0};
            const double exact = call("ridgeLobe", in)[0];
            const double bound = 1e-5 - 3e-7 * e * std::log(std::cos(to));
            EXPECT_NEAR(shaderRidgeLobe(in) / exact, 1.0, bound) << e << ' ' << to;
        }
    }
}

} // namespace
} // namespace patina::physics::ridges_test
