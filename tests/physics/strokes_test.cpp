// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of strokes, and models that draw on the surface, in double precision.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::strokes_test {
namespace {

/// A place on a mark that faces the viewer.
struct Mark {
    double along = 0.5;
    double across = 0.5;
    double pixel = 0.05;
    glm::dvec3 n{0.0, 0.0, 1.0};
    glm::dvec3 light{0.5};
    double order = 0.5;
    double phase = 0.5;

    std::array<double, 20> numbers() const {
        return {along, across, pixel, 2.0,     n.x,     n.y,     n.z,   1.0, 0.0, 0.0,
                0.0,   0.0,    1.0,   light.x, light.y, light.z, order, 0.5, 0.5, phase};
    }
};

double floatOf(const Subject& strokes, const char* function, const Mark& mark) {
    return strokes.code->call<1>(function, mark.numbers(), strokes.parameters)[0];
}

TEST(Stipples, OfADarkerSurface_KeepThoseOfALighterOne) {
    const Subject dots("strokes", "stipple");
    for (double order = 0.05; order < 1.0; order += 0.05) {
        double before = 0.0;
        for (double light = 1.0; light >= 0.0; light -= 0.05) {
            const double ink =
                floatOf(dots, "Opacity", {.light = glm::dvec3(light), .order = order});
            EXPECT_GE(ink, before - 1e-12) << order << ' ' << light;
            before = ink;
        }
    }
}

TEST(PenStrokes, ThatCross_ComeWhereItIsDark) {
    const Subject pen("strokes", "pen", {{"tone.light", 1.0}, {"opacity", 1.0}});
    const auto inkAt = [&](double light, double phase) {
        return floatOf(pen, "Opacity", {.light = glm::dvec3(light), .order = 0.01, .phase = phase});
    };
    EXPECT_GT(inkAt(0.75, 0.1), 0.9);
    EXPECT_EQ(inkAt(0.75, 0.6), 0.0);
    EXPECT_GT(inkAt(0.5, 0.6), 0.9);
    EXPECT_EQ(inkAt(0.5, 0.9), 0.0);
    EXPECT_GT(inkAt(0.1, 0.9), 0.9);
}

TEST(Graftals, NearTheSilhouette_AreAllThere) {
    const Subject tufts("strokes", "graftal", {{"rim", 0.3}, {"inside", 0.1}});
    const auto shareAt = [&](double cosine) {
        return floatOf(tufts, "Share", {.n = {std::sqrt(1.0 - cosine * cosine), 0.0, cosine}});
    };
    EXPECT_NEAR(shareAt(0.1), 1.0, 1e-12);
    EXPECT_NEAR(shareAt(0.9), 0.1, 1e-12);
    EXPECT_EQ(shareAt(-0.5), 0.0);
}

TEST(BrushStrokes, WithLessPaint_LeaveMoreGaps) {
    double before = 2.0;
    for (const double loading : {1.0, 0.7, 0.4, 0.1}) {
        const Subject brush("strokes", "brush", {{"loading", loading}});
        double ink = 0.0;
        for (int i = 0; i < 200; ++i) {
            ink += floatOf(brush, "Shape", {.across = (i + 0.5) / 200.0, .pixel = 0.02}) / 200.0;
        }
        EXPECT_LT(ink, before);
        before = ink;
    }
}

/// How much ink a drawing has at a place of a plane that faces the viewer.
double inkOn(const std::string& model, const glm::dvec3& place, double pixel, double nl,
             const Values& more = {}) {
    Values values{{"diffuse.color", glm::dvec3(0.0)},
                  {"ink.color", glm::dvec3(1.0)},
                  {"tone.light", 1.0},
                  {"place", place},
                  {"place.pixel", pixel}};
    values.insert(more.begin(), more.end());
    const double angle = std::acos(nl) * 180.0 / std::numbers::pi;
    return Subject("models", model, values).shade(geometry(direction(angle, 20.0), {0, 0, 1})).x;
}

TEST(SurfaceHalftone, OnAnyScale_CoversTheTone) {
    for (const double pixel : {0.004, 0.005, 0.006, 0.0071, 0.01}) {
        double ink = 0.0;
        constexpr int steps = 40;
        for (int i = 0; i < steps * steps; ++i) {
            const glm::dvec3 place(0.25 * (i % steps + 0.5) / steps,
                                   0.25 * (i / steps + 0.5) / steps, 0.0);
            ink += inkOn("surface-halftone", place, pixel, 0.75, {{"cell", 12.0}});
        }
        EXPECT_NEAR(ink / (steps * steps), 0.25, 0.05) << pixel;
    }
}

/// The places lie on a ball of radius 1 beside the origin, where lattices of two axes meet.
TEST(SurfaceHalftone, WhereAnotherAxisTakesOver_KeepsTheToneWithoutASudden) {
    double jump = 0.0;
    double sum = 0.0;
    int count = 0;
    for (int row = 0; row < 30; ++row) {
        double before = -1.0;
        for (double angle = 40.0; angle < 50.0; angle += 0.025) {
            const double turn = angle * std::numbers::pi / 180.0;
            const double height = 0.011 * row;
            const double across = std::sqrt(1.0 - height * height);
            const glm::dvec3 n(across * std::sin(turn), height, across * std::cos(turn));
            const double ink =
                inkOn("surface-halftone", n + glm::dvec3(0.0137, 0.071, 0.0313), 0.005, 0.7,
                      {{"cell", 8.0},
                       {"place.normal", n},
                       {"place.view", n},
                       {"place.curvature", glm::dvec3(1.0) - n * n},
                       {"place.curvature.mixed", -glm::dvec3(n.x * n.y, n.y * n.z, n.z * n.x)}});
            jump = before < 0.0 ? jump : std::max(jump, std::abs(ink - before));
            before = ink;
            sum += ink;
            ++count;
        }
    }
    EXPECT_LT(jump, 0.15);
    EXPECT_NEAR(sum / count, 0.3, 0.05);
}

/// The ink of strokes along x on a plane that faces the viewer, at a level of the maps.
double artInk(double x, double y, double level, double dark) {
    return inkOn("tonal-art-maps", {x, y, 0.0}, 0.05 * std::exp2(-level), 1.0 - dark,
                 {{"map.size", 1.0}, {"line.direction", glm::dvec3(0.0, 1.0, 0.0)}});
}

TEST(TonalArtMaps, OfADarkerTone_KeepTheInkOfALighterOne) {
    for (int i = 0; i < 200; ++i) {
        double before = 0.0;
        for (double dark = 0.0; dark < 1.01; dark += 1.0 / 12.0) {
            const double ink = artInk(0.0137 * i, 0.0071 * i, 3.0, dark);
            EXPECT_GE(ink, before - 1e-9) << i << ' ' << dark;
            before = ink;
        }
    }
}

TEST(TonalArtMaps, OfAFinerLevel_KeepTheStrokesOfACoarserOne) {
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const double x = 0.0137 * i;
        const double y = 0.0071 * i;
        if (artInk(x, y, 2.0, 2.0 / 6.0) < 0.999) {
            continue;
        }
        ++found;
        double finer = 0.0;
        for (double aside = -0.012; aside < 0.012; aside += 0.001) {
            finer = std::max(finer, artInk(x, y + aside, 3.0, 2.0 / 6.0));
        }
        EXPECT_GT(finer, 0.9) << x << ' ' << y;
    }
    EXPECT_GT(found, 5);
}

TEST(TonalArtMaps, OnAnyLevel_AreAboutAsDark) {
    for (const double dark : {0.25, 0.9}) {
        double coarse = 0.0;
        double fine = 0.0;
        for (int i = 0; i < 900; ++i) {
            coarse += artInk(0.03301 * i, (i % 30) / 30.0, 1.0, dark);
            fine += artInk(0.03301 * i, (i % 30) / 30.0, 3.0, dark);
        }
        EXPECT_NEAR(coarse / fine, 1.0, 0.2) << dark;
    }
}

TEST(TonalArtMaps, ReadFromMaps_AreOnAverageAFortiethOfFullInkOff) {
    double off = 0.0;
    for (int i = 0; i < 900; ++i) {
        const auto ink = [i](const char* level) {
            const Subject subject("models", "tonal-art-maps",
                                  {{"diffuse.color", glm::dvec3(0.0)},
                                   {"ink.color", glm::dvec3(1.0)},
                                   {"tone.light", 1.0},
                                   {"place", glm::dvec3(0.03301 * i, (i % 30) / 30.0, 0.0)},
                                   {"place.pixel", 0.007}},
                                  {{"strokes", level}});
            return subject.shade(geometry(direction(60.0, 20.0), {0, 0, 1})).x;
        };
        off += std::abs(ink("maps") - ink("exact")) / 900.0;
    }
    EXPECT_NEAR(off, 0.025, 0.005);
}

TEST(TonalArtMaps, OnATube_RunAroundIt) {
    // A tube along x of radius 0.5: strokes run along y where they follow the form.
    const auto change = [](const glm::dvec3& step, double follow) {
        double sum = 0.0;
        for (int i = 0; i < 400; ++i) {
            const auto ink = [&](double aside) {
                return inkOn("tonal-art-maps",
                             glm::dvec3(0.0137 * i, 0.0371 * i, 0.0) + aside * step, 0.008, 0.75,
                             {{"line.direction", glm::dvec3(0.0, 1.0, 0.0)},
                              {"follow", follow},
                              {"place.curvature", glm::dvec3(0.0, 2.0, 0.0)}});
            };
            sum += std::abs(ink(0.004) - ink(0.0));
        }
        return sum;
    };
    const glm::dvec3 x(1.0, 0.0, 0.0);
    const glm::dvec3 y(0.0, 1.0, 0.0);
    EXPECT_GT(change(x, 1.0), 3.0 * change(y, 1.0));
    EXPECT_GT(change(y, 0.0), 3.0 * change(x, 0.0));
}

class DrawnOnTheSurface : public testing::TestWithParam<const char*> {};

/// A scale of the lattice ends at some width of a pixel; nothing may change there.
TEST_P(DrawnOnTheSurface, AsItComesNearer_ChangesWithoutASudden) {
    for (int i = 0; i < 12; ++i) {
        const glm::dvec3 place(0.13 + 0.0071 * i, 0.21 - 0.0037 * i, 0.05);
        double before = inkOn(GetParam(), place, 0.003, 0.3);
        for (double pixel = 0.003; pixel < 0.0125; pixel *= 1.002) {
            const double ink = inkOn(GetParam(), place, pixel, 0.3);
            EXPECT_LT(std::abs(ink - before), 0.2) << pixel;
            before = ink;
        }
    }
}

TEST_P(DrawnOnTheSurface, WhereItIsDarker_HasMoreInk) {
    double bright = 0.0;
    double dark = 0.0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 place(0.0017 * i, 0.0023 * i, 0.0);
        bright += inkOn(GetParam(), place, 0.004, 0.8) / 300.0;
        dark += inkOn(GetParam(), place, 0.004, 0.2) / 300.0;
    }
    EXPECT_GT(dark, bright + 0.1);
}

INSTANTIATE_TEST_SUITE_P(Models, DrawnOnTheSurface,
                         testing::Values("tonal-hatching", "engraving", "surface-halftone",
                                         "tonal-art-maps"));

} // namespace
} // namespace patina::physics::strokes_test
