// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>

#include <gtest/gtest.h>

#include "lobe_cases.h"
#include "measure/error/parallel.h"
#include "measure/lobe/albedo_curve.h"
#include "measure/lobe/lobe_lines.h"
#include "measure/stability/sweep_cases.h"
#include "support/long_form.h"

namespace patina::physics::albedo_curve_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

/// Returns the albedo by a rule of 2048 points of the elevation, whose squared sine is even in
/// projected solid angle, and as many as the azimuth needs. What is isotropic is the same on both
/// sides of the plane of incidence: one of them is counted.
glm::dvec3 albedoByPoints(const LobeModel& model, double angle, int azimuths, bool isIsotropic) {
    constexpr int elevations = 2048;
    const int counted = isIsotropic ? azimuths / 2 : azimuths;
    const glm::dvec3 l(std::sin(angle), 0.0, std::cos(angle));
    glm::dvec3 sum(0.0);
    for (int i = 0; i < elevations; ++i) {
        // With x = 1 - (1 - t)^2 steps shrink towards the horizon.
        const double t = (i + 0.5) / elevations;
        const double cos2 = (1.0 - t) * (1.0 - t);
        const double s = std::sqrt((1.0 - cos2));
        glm::dvec3 ring(0.0);
        for (int j = 0; j < counted; ++j) {
            const double phi = 2.0 * pi * (j + 0.5) / azimuths;
            ring += model.reflectance(l, {s * std::cos(phi), s * std::sin(phi), 1.0 - t});
        }
        sum += ring * (2.0 * (1.0 - t) / elevations / counted);
    }
    return pi * sum;
}

TEST(AlbedoCurve, OfEveryReflectance_IsThatOf2048Points) {
    constexpr double tolerance = 1e-4;
    for (const Block* block : catalog().ofKind(kinds::models)) {
        if (!whyNoReflectance(*block).empty()) {
            continue;
        }
        const LobeModel model = modelOf(defaultMaterial(*block));
        const int azimuths = block->id == "grating" ? 640 : 160; // lines of 0.007 rad
        const bool isIsotropic = std::ranges::count(block->claims, "isotropic") > 0;
        for (const double degrees : tests::everyNth<double>({35.0, 0.0, 75.0}, 3)) {
            const glm::dvec3 counted =
                albedoByPoints(model, degrees * degree, azimuths, isIsotropic);
            const AlbedoPoint point = directionalAlbedo(model, {degrees * degree, 0.0});
            EXPECT_LT(worst(point.albedo, counted), tolerance) << block->id << ' ' << degrees;
            EXPECT_LT(point.uncertainty, 10.0 * tolerance) << block->id << ' ' << degrees;
        }
    }
}

/// A grating's lines are finer than the steps of a sketch, which is drawn while a slider moves.
TEST(LobeSketch, OfEveryModel_IsNearTheWholePlot) {
    LobeRequest request;
    request.plot = LobePlot::Albedo;
    for (const Block* block : catalog().ofKind(kinds::models)) {
        if (!whyNoReflectance(*block).empty() || block->id == "grating") {
            continue;
        }
        request.isSketch = true;
        const auto sketch = lobeLines(catalog(), defaultMaterial(*block), request);
        ASSERT_TRUE(sketch);
        const LobeModel model = modelOf(defaultMaterial(*block));
        const LobeLine& line = sketch->lines.front();
        for (std::size_t i = 0; i < line.values.size() && line.at[i] < 85.0; i += 2) {
            const glm::dvec3 whole = directionalAlbedo(model, {line.at[i] * degree, 0.0}).albedo;
            EXPECT_LT(worst(line.values[i], whole), 0.02) << block->id << ' ' << line.at[i];
        }
    }
}

TEST(AlbedoCurve, OfLambert_IsItsColourAtEveryAngle) {
    const LobeModel model =
        modelOf(materialOf("lambert", {{"diffuse.color", glm::dvec3(0.25, 0.5, 1.0)}}));
    for (const AlbedoPoint& point : albedoCurve(model, 0.0, albedoAngles(5.0))) {
        EXPECT_LT(worst(point.albedo, {0.25, 0.5, 1.0}), 1e-5) << point.angle / degree;
    }
}

TEST(AlbedoCurve, OfANarrowLobe_DoesNotMissIt) {
    // At this angle next to nothing of either lobe is masked or below the horizon.
    const LobeModel model = modelOf(
        materialOf("cook-torrance", {{"diffuse.color", glm::dvec3(0.0)}, {"roughness", 0.001}}));
    const AlbedoPoint point = directionalAlbedo(model, {0.3, 0.0});
    const LobeModel broad = modelOf(
        materialOf("cook-torrance", {{"diffuse.color", glm::dvec3(0.0)}, {"roughness", 0.05}}));
    EXPECT_NEAR(point.albedo.x / directionalAlbedo(broad, {0.3, 0.0}).albedo.x, 1.0, 0.01);
}

TEST(AlbedoCurve, IsFiniteForEveryEdgeCase) {
    const IntegralAim coarse{0.05, 4};
    constexpr double angles[] = {0.0, 1.0, pi / 2.0};
    std::size_t next = 0;
    for (const Block* block : catalog().ofKind(kinds::models)) {
        const auto rows = sweepRows(*sweepVariant(catalog(), defaultMaterial(*block)));
        for (const EvalCase& row : tests::everyNth(rows, 4)) {
            Material material = defaultMaterial(*block);
            material.model.parameters = row.block.values;
            const LobeModel model = modelOf(material);
            const double angle = angles[next++ % std::size(angles)];
            const AlbedoPoint point = directionalAlbedo(model, {angle, 0.4}, coarse);
            EXPECT_TRUE(
                std::isfinite(point.albedo.x + point.albedo.y + point.albedo.z + point.uncertainty))
                << block->id << ' ' << angle;
        }
    }
}

/// A plot that is superseded ends within an angle's integral, of which some take seconds.
TEST(AlbedoCurve, NoLongerWanted_EndsWithinAnAngle) {
    const LobeModel model = modelOf(materialOf("phong", {}));
    std::atomic<int> asked = 0;
    const auto curve = albedoCurve(model, 0.0, albedoAngles(5.0), {}, [&asked] {
        return ++asked < 40; // an angle has 75 rings at the least
    });
    EXPECT_TRUE(curve.empty());
    EXPECT_LT(asked, 400 * int(parallelParts()));
}

TEST(EnergyRange, OfAnEvenCurve_IsItsValue) {
    const LobeModel model =
        modelOf(materialOf("lambert", {{"diffuse.color", glm::dvec3(0.25, 0.5, 1.0)}}));
    const EnergyRange range = energyRange(albedoCurve(model, 0.0, albedoAngles(10.0)));
    for (const glm::dvec3& each : {range.min, range.mean, range.max}) {
        EXPECT_LT(worst(each, {0.25, 0.5, 1.0}), 1e-5);
    }
}

TEST(EnergyRange, OfASurfaceWithAGrain_CountsLightFromAllAzimuths) {
    const Material brushed = materialOf(
        "ward",
        {{"grain", std::string("anisotropic")}, {"roughness.x", 0.05}, {"roughness.y", 0.5}});
    const auto rangeFrom = [&brushed](double azimuth) {
        LobeRequest request{.plot = LobePlot::Albedo, .incoming = {0.0, azimuth}};
        std::vector<LobeLine> lines = lobeLines(catalog(), brushed, request)->lines;
        const EnergyRange own = energyRange(lines);
        const auto turned = turnedAlbedos(catalog(), brushed, request, [] { return true; });
        EXPECT_EQ(turned.size(), 3u);
        lines.insert(lines.end(), turned.begin(), turned.end());
        return std::pair(own, energyRange(lines));
    };
    const auto [along, allFromAlong] = rangeFrom(0.0);
    const auto [across, allFromAcross] = rangeFrom(0.5 * pi);
    const double apart = worst(along.max, across.max);
    EXPECT_GT(apart, 0.01);
    EXPECT_LT(worst(allFromAlong.max, allFromAcross.max), 0.25 * apart);
    EXPECT_GE(allFromAlong.max.x, std::max(along.max.x, across.max.x) - 0.25 * apart);
}

TEST(EnergyRange, OfASurfaceWithoutAGrain_HasNoOtherAzimuths) {
    const LobeRequest request{.plot = LobePlot::Albedo, .incoming = {}};
    const auto isWanted = [] { return true; };
    EXPECT_TRUE(turnedAlbedos(catalog(), materialOf("lambert"), request, isWanted).empty());
}

} // namespace
} // namespace patina::physics::albedo_curve_test
