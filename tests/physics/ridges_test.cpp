// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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

/// Ridges of which a pixel sees a strip at this place, in periods; the strips of `pixels` pixels
/// side by side are one period.
Subject seenRidges(Values values, double place, int pixels) {
    values["ridge.width"] = 1.0;
    values["coordinates"] = glm::dvec2(0.0, place);
    values["coordinates.up"] = glm::dvec2(0.0, 1.0 / (1.25 * pixels));
    return {"models", "seen-ridges", values};
}

double meanOverAPeriod(const Values& values, const reference::Geometry& g) {
    constexpr int pixels = 24;
    double sum = 0.0;
    for (int i = 0; i < pixels; ++i) {
        const Subject model = seenRidges(values, (i + 0.3) / pixels, pixels);
        sum += model.shade(g, allReflected().filler()).x;
    }
    return sum / pixels;
}

/// Calls `check` for ridges of several shapes, white but for a highlight and matte alone.
template <class Check>
void forRidges(Check&& check) {
    for (const auto& [spacing, height] :
         {std::pair{2.0, 0.5}, std::pair{2.5, -0.3}, std::pair{4.0, 0.9}, std::pair{3.0, -1.0}}) {
        for (const bool isMatte : {true, false}) {
            Values values = ridges(spacing, height, 40.0);
            values["diffuse.color"] = isMatte ? white : black;
            values["specular.color"] = isMatte ? black : white;
            for (const std::string name : {"A", "B", "C", "D", "E", "F"}) {
                SCOPED_TRACE(std::to_string(spacing) + ' ' + std::to_string(height) + name);
                check(values, pairOfDirections(name), isMatte);
            }
        }
    }
}

/// The matte parts are both in closed form; the quadrature of highlights errs by 1e-5.
TEST(SeenRidges, MeanOverAPeriod_IsPoulinFournier) {
    forRidges([](const Values& values, const reference::Geometry& g, bool isMatte) {
        const Subject average("models", "poulin-fournier", values);
        const double wanted = average.shade(g, allReflected().filler()).x;
        EXPECT_NEAR(meanOverAPeriod(values, g), wanted, isMatte ? 1e-12 : 1e-5 * wanted + 1e-7);
    });
}

TEST(SeenRidges, APixelThatSeesAPeriod_IsPoulinFournierWithoutASeam) {
    forRidges([](const Values& values, const reference::Geometry& g, bool) {
        const Subject average("models", "poulin-fournier", values);
        const double wanted = average.shade(g, allReflected().filler()).x;
        for (const double wide : {1.0, 1.0 / 3.0}) {
            Values far = values;
            far["ridge.width"] = wide;
            far["coordinates.up"] = glm::dvec2(0.0, 0.801);
            const Subject model("models", "seen-ridges", far);
            EXPECT_NEAR(model.shade(g, allReflected().filler()).x, wanted, 1e-12 * wanted + 1e-15);
        }
        Values near = values;
        near["ridge.width"] = 1.0;
        near["coordinates"] = glm::dvec2(0.0, 0.4);
        near["coordinates.up"] = glm::dvec2(0.0, 0.7999);
        const Subject model("models", "seen-ridges", near);
        EXPECT_NEAR(model.shade(g, allReflected().filler()).x, wanted, 1e-3 * wanted + 1e-7);
    });
}

/// White matte ridges where a line of sight meets them that passes the height of the tops at this
/// place: the nearest of ridges and floor, and whether light comes there.
double castRay(const reference::Geometry& g, double spacing, double height, double place) {
    const glm::dvec2 l{g.l.y, g.l.z};
    const glm::dvec2 v = glm::dvec2(g.v.y, g.v.z) / std::hypot(g.v.y, g.v.z);
    const glm::dvec2 top{place * spacing, 1.0};
    double nearest = (1.0 - height) / v.y; // the way down to the floor
    glm::dvec2 n{0.0, 1.0};
    for (int k = -60; k <= 60; ++k) {
        const glm::dvec2 o{top.x - k * spacing, top.y};
        const double along = o.x * v.x + o.y * v.y;
        const double inside = along * along - (o.x * o.x + o.y * o.y - 1.0);
        if (inside > 0.0 && along - std::sqrt(inside) < nearest) {
            nearest = along - std::sqrt(inside);
            n = o - nearest * v;
        }
    }
    const double facing = n.x * l.x + n.y * l.y;
    const glm::dvec2 met = top - nearest * v + 1e-8 * n;
    return facing > 0.0 && !isBlocked(met, l / std::hypot(l.x, l.y), spacing) ? facing : 0.0;
}

TEST(SeenRidges, StripsOfAPeriod_AgreeWithCastRays) {
    constexpr int places = 97;
    for (const double height : {-0.6, 0.0, 0.7}) {
        Values values = ridges(3.0, height, 1.0);
        values["diffuse.color"] = white;
        values["specular.color"] = black;
        for (const std::string name : {"A", "B", "C", "D", "E", "F"}) {
            const auto g = pairOfDirections(name);
            int far = 0;
            for (int i = 0; i < places; ++i) {
                const double place = (i + 0.5) / places - 0.5;
                const double shown = seenRidges(values, place, 64).shade(g).x;
                far += std::abs(shown - castRay(g, 3.0, height, place)) > 0.03 ? 1 : 0;
            }
            // A ridge's edge and a shadow's, each as wide as three places in a window of 1 / 32.
            EXPECT_LE(far, 6) << height << name;
        }
    }
}

TEST(SeenRidges, WithoutTextureCoordinates_HaveTheirAverage) {
    Values values = ridges(2.5, 0.0, 30.0);
    const Subject average("models", "poulin-fournier", values);
    values["coordinates"] = glm::dvec2(0.3, 0.7);
    const Subject model("models", "seen-ridges", values);
    const auto g = pairOfDirections("B");
    EXPECT_NEAR(model.shade(g, allReflected().filler()).x,
                average.shade(g, allReflected().filler()).x, 1e-14);
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

/// The level of fewer points, in units of the whole lobe's integral: an arc of any length, and one
/// that is shorter than a deviation.
TEST(SeenRidges, OfFivePoints_AreOffByNoMoreThanTheirLabelSays) {
    double longArcs = 0.0;
    double shortArcs = 0.0;
    for (const double e : {0.0, 1.0, 20.0, 500.0, 1e5}) {
        const double deviation = std::sqrt(1.0 / (e + 1.0));
        const double whole = std::sqrt(2.0 * std::numbers::pi) * deviation;
        for (double from = -4.0; from < 4.0; from += 0.1) {
            for (const double length : {0.03, 0.3, 1.0, 2.0, 4.0, 8.0}) {
                const double begin = std::max(from * deviation, -1.4);
                const double end = std::min((from + length) * deviation, 1.4);
                const std::vector<double> in{begin, end, 0.0, 0.1, 0.9, e, 1.4, 1.0, 1.57, 0.0};
                const double error =
                    std::abs(call("quickRidgeLobe", in)[0] - call("ridgeLobe", in)[0]) / whole;
                (length > 1.0 ? longArcs : shortArcs) =
                    std::max(length > 1.0 ? longArcs : shortArcs, error);
            }
        }
    }
    EXPECT_LT(longArcs, 0.003);
    EXPECT_GT(longArcs, 0.0005);
    EXPECT_LT(shortArcs, 1e-4);
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
