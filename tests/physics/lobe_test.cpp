// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "lobe_cases.h"
#include "measure/lobe/half_difference_slice.h"
#include "measure/lobe/lobe_lines.h"
#include "measure/lobe/lobe_scale.h"
#include "measure/lobe/lobe_solid.h"
#include "measure/stability/sweep_cases.h"

namespace patina::physics::lobe_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

TEST(LobeSolid, OfLambert_IsEvenOverTheWholeHemisphere) {
    const LobeModel model = modelOf(materialOf("lambert", {{"diffuse.color", glm::dvec3(0.5)}}));
    for (const double degrees : {0.0, 50.0, 90.0}) {
        const LobeSolid solid = lobeSolid(model, {degrees * degree, 0.3});
        ASSERT_EQ(solid.f.size(), solid.directions.size());
        for (std::size_t i = 0; i < solid.f.size(); ++i) {
            EXPECT_NEAR(glm::length(solid.directions[i]), 1.0, 1e-12);
            EXPECT_GE(solid.directions[i].z, 0.0);
            EXPECT_NEAR(solid.f[i].x, 0.5 / pi, 1e-9) << degrees;
        }
        EXPECT_NEAR(solid.directions.back().z, 0.0, 1e-12);
    }
}

TEST(LobeSolid, OfANarrowLobe_HasItsPeakInTheFirstRing) {
    const LobeModel model =
        modelOf(materialOf("phong", {{"diffuse.color", glm::dvec3(0.0)}, {"shininess", 5000.0}}));
    const Incoming incoming{0.7, 0.2};
    const LobeSolid solid = lobeSolid(model, incoming);
    const glm::dvec3 peak = model.reflectance(incoming.direction(), incoming.across(0.7));
    ASSERT_GT(peak.x, 0.0);
    EXPECT_NEAR(solid.f[solid.place(0, 5)].x / peak.x, 1.0, 1e-9);
    EXPECT_GT(solid.f[solid.place(1, 0)].x, 0.5 * peak.x); // the mesh follows the lobe
    EXPECT_LT(solid.f[solid.place(20, 0)].x, 0.01 * peak.x);
}

TEST(PolarCurve, OfANarrowLobe_HasItsPeakAndBend) {
    const LobeModel model = modelOf(materialOf("phong", {{"shininess", 100000.0}}));
    const Incoming incoming{40.0 * degree, 0.0};
    const auto curve = polarCurve(model, incoming);
    double peak = 0.0;
    double at = 0.0;
    for (const LobePoint& point : curve) {
        if (point.f.x > peak) {
            peak = point.f.x;
            at = point.angle;
        }
    }
    EXPECT_NEAR(at, incoming.angle, 1e-6);
    EXPECT_EQ(peak, model.reflectance(incoming.direction(), incoming.across(incoming.angle)).x);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const double middle = 0.5 * (curve[i].angle + curve[i - 1].angle);
        const double line = 0.5 * (curve[i].f.x + curve[i - 1].f.x);
        EXPECT_NEAR(model.reflectance(incoming.direction(), incoming.across(middle)).x, line,
                    0.004 * peak)
            << middle;
    }
}

TEST(PolarCurve, IsFiniteForEveryEdgeCase) {
    for (const Block* block : catalog().ofKind(kinds::models)) {
        for (const EvalCase& row : sweepRows(*sweepVariant(catalog(), defaultMaterial(*block)))) {
            Material material = defaultMaterial(*block);
            material.model.parameters = row.block.values;
            const LobeModel model = modelOf(material);
            for (const double angle : {0.0, 1.2, pi / 2.0}) {
                for (const LobePoint& point : polarCurve(model, {angle, 0.3}, {30, 0.1, 200})) {
                    EXPECT_TRUE(std::isfinite(point.f.x + point.f.y + point.f.z)) << block->id;
                }
            }
        }
    }
}

TEST(LobeTerms, OfEveryModel_AddUpToTheWhole) {
    for (const Block* block : catalog().ofKind(kinds::models)) {
        if (!hasTerms(*block)) {
            EXPECT_FALSE(LobeModel::create(catalog(), defaultMaterial(*block), LobeTerm::Diffuse));
            continue;
        }
        const Material material = defaultMaterial(*block);
        const LobeModel whole = modelOf(material);
        const LobeModel diffuse = modelOf(material, LobeTerm::Diffuse);
        const LobeModel highlight = modelOf(material, LobeTerm::Highlight);
        const Incoming incoming{0.7, 0.2};
        for (const double angle : {-1.0, 0.0, 0.6, 1.3}) {
            const glm::dvec3 l = incoming.direction();
            const glm::dvec3 v = incoming.across(angle);
            const glm::dvec3 sum = diffuse.reflectance(l, v) + highlight.reflectance(l, v);
            EXPECT_LT(worst(sum, whole.reflectance(l, v)), 1e-12) << block->id;
        }
    }
}

TEST(HalfDifferenceSlice, OfAMirrorishLobe_PeaksWhereTheHalfVectorIsTheNormal) {
    const HalfDifferenceSlice slice = halfDifferenceSlice(
        modelOf(
            materialOf("cook-torrance", {{"roughness", 0.1}, {"diffuse.color", glm::dvec3(0.0)}})),
        30);
    EXPECT_GT(slice.at(0, 5).x, 10.0 * slice.at(20, 5).x);
}

TEST(HalfDifferenceSlice, OfLambert_IsEven) {
    const HalfDifferenceSlice slice = halfDifferenceSlice(
        modelOf(materialOf("lambert", {{"diffuse.color", glm::dvec3(0.5)}})), 16);
    for (const glm::dvec3& f : slice.cells) {
        EXPECT_NEAR(f.x, 0.5 / pi, 1e-12);
    }
}

TEST(HalfDifferenceSlice, WithAHighlight_IsShownSoThatTheRestIsNotBlack) {
    HalfDifferenceSlice slice{10, std::vector<glm::dvec3>(100, glm::dvec3(0.2))};
    slice.cells.back() = glm::dvec3(1000.0);
    const double white = whiteOf(std::array{&std::as_const(slice)});
    EXPECT_DOUBLE_EQ(white, 0.2);
    EXPECT_NEAR(shownColor(slice.cells.back(), LobeScale::Linear, white).x, 1.0, 1e-12);
    EXPECT_NEAR(shownColor(glm::dvec3(0.1), LobeScale::Linear, white).x, 0.735, 1e-3); // in sRGB
    slice.cells.assign(100, glm::dvec3(0.0));
    slice.cells.front().y = 7.0;
    EXPECT_DOUBLE_EQ(whiteOf(std::array{&std::as_const(slice)}), 7.0);
}

TEST(LobeScale, OfALength_IsUndoneByItsInverse) {
    for (const LobeScale scale : {LobeScale::Linear, LobeScale::CubeRoot, LobeScale::Log}) {
        EXPECT_EQ(lobeLength(scale, 0.0, 2.0), 0.0);
        EXPECT_EQ(lobeLength(scale, 1.0, 0.0), 0.0);
        EXPECT_EQ(lobeLength(scale, 2.0, 2.0), 1.0);
        EXPECT_NEAR(valueAtLength(scale, lobeLength(scale, 0.3, 2.0), 2.0), 0.3, 1e-12);
        EXPECT_EQ(lobeScaleOf(wordOf(scale)), scale);
    }
}

TEST(NoReflectance, IsSaidOfDrawingsAlone) {
    for (const Block* block : catalog().ofKind(kinds::models)) {
        const bool draws = block->id == "gooch" || block->id == "toon" || block->id == "halftone" ||
                           block->id == "hatching" || block->id == "tonal-hatching" ||
                           block->id == "engraving" || block->id == "surface-halftone" ||
                           block->id == "tonal-art-maps";
        EXPECT_EQ(!whyNoReflectance(*block).empty(), draws) << block->id;
    }
}

} // namespace
} // namespace patina::physics::lobe_test
