// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "measure/lobe/albedo_curve.h"
#include "measure/lobe/fresnel_curve.h"
#include "measure/lobe/half_difference_slice.h"
#include "measure/lobe/lobe_factor.h"
#include "measure/lobe/lobe_lines.h"
#include "measure/lobe/lobe_scale.h"
#include "measure/lobe/lobe_solid.h"
#include "measure/lobe/table_files.h"
#include "measure/stability/sweep_cases.h"
#include "physics_cases.h"

namespace patina::physics::lobe_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

/// Is a material of a model with other values than the defaults.
Material materialOf(const std::string& model, const Values& values = {}) {
    Material material = defaultMaterial(*catalog().find(kinds::models, model));
    for (const auto& [id, value] : values) {
        material.model.parameters[id] = value;
    }
    return material;
}

LobeModel modelOf(const Material& material, LobeTerm term = LobeTerm::Whole) {
    auto model = LobeModel::create(catalog(), material, term);
    if (!model) {
        throw std::runtime_error(model.error().text());
    }
    return std::move(*model);
}

/// Returns the albedo by a rule of 2048 points of the elevation, whose squared sine is even in
/// projected solid angle, and as many as the azimuth needs.
/// What is isotropic is the same on both sides of the plane of incidence: one of them is counted.
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

double worst(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
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
        for (const double degrees : {0.0, 35.0, 75.0}) {
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
        for (std::size_t i = 0; i < line.values.size() && line.degrees[i] < 85.0; i += 2) {
            const glm::dvec3 whole =
                directionalAlbedo(model, {line.degrees[i] * degree, 0.0}).albedo;
            EXPECT_LT(worst(line.values[i], whole), 0.02) << block->id << ' ' << line.degrees[i];
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
        for (const EvalCase& row : sweepRows(*sweepVariant(catalog(), defaultMaterial(*block)))) {
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

/// Returns a factor of a material's highlight, which must have it.
LobeFactor factorOf(const Material& material, LobeTerm term) {
    auto factor = LobeFactor::create(catalog(), material, term);
    if (!factor) {
        throw std::runtime_error(factor.error().text());
    }
    return std::move(*factor);
}

/// Returns the integral of a distribution over half vectors, times their cosine or not.
double integralOver(const LobeFactor& distribution, bool isProjected) {
    constexpr int elevations = 2000;
    constexpr int azimuths = 72;
    double sum = 0.0;
    for (int i = 0; i < elevations; ++i) {
        const double theta = 0.5 * pi * (i + 0.5) / elevations;
        for (int j = 0; j < azimuths; ++j) {
            const double phi = 2.0 * pi * (j + 0.5) / azimuths;
            const glm::dvec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta));
            sum += distribution.at(h, h).x * std::sin(theta) * (isProjected ? h.z : 1.0);
        }
    }
    return sum * (0.5 * pi / elevations) * (2.0 * pi / azimuths);
}

TEST(LobeFactor, Distribution_HasRoomForTheWholeSurface) {
    const Block& block = *catalog().find(kinds::models, "cook-torrance");
    const Parameter& shape = *block.parameter("distribution");
    for (std::size_t i = 0; i < shape.values.size(); ++i) {
        const Material material =
            materialOf("cook-torrance", {{"distribution", shape.values[i].id}, {"roughness", 0.3}});
        EXPECT_NEAR(integralOver(factorOf(material, LobeTerm::Distribution), true), 1.0, 2e-3)
            << shape.values[i].id;
    }
    EXPECT_NEAR(integralOver(factorOf(materialOf("ward"), LobeTerm::Distribution), true), 1.0,
                2e-3);
    EXPECT_NEAR(
        integralOver(factorOf(materialOf("ashikhmin-shirley"), LobeTerm::Distribution), false), 1.0,
        2e-3);
}

TEST(LobeFactor, ProductOfAll_IsTheHighlight) {
    for (const char* masking : {"v-cavity", "smith", "smith-correlated", "schlick-smith"}) {
        for (const char* cosine : {"half", "light", "view"}) {
            const Material material =
                materialOf("cook-torrance", {{"masking", std::string(masking)},
                                             {"fresnel.cosine", std::string(cosine)},
                                             {"roughness", 0.4}});
            const LobeModel highlight = modelOf(material, LobeTerm::Highlight);
            const LobeFactor D = factorOf(material, LobeTerm::Distribution);
            const LobeFactor G = factorOf(material, LobeTerm::Masking);
            const LobeFactor F = factorOf(material, LobeTerm::Fresnel);
            const Incoming incoming{0.9, 0.2};
            const glm::dvec3 l = incoming.direction();
            for (const double angle : {-0.5, 0.3, 0.9, 1.4}) {
                const glm::dvec3 v = incoming.across(angle);
                const glm::dvec3 f = D.at(l, v) * G.at(l, v) * F.at(l, v) / (4.0 * l.z * v.z);
                EXPECT_LT(worst(highlight.reflectance(l, v), f), 1e-9 * f.x + 1e-12)
                    << masking << ' ' << cosine << ' ' << angle;
                EXPECT_GE(G.at(l, v).x, 0.0);
                EXPECT_LE(G.at(l, v).x, 1.0 + 1e-12);
            }
        }
    }
}

TEST(LobeFactor, OfAModelWithoutIt_IsAnErrorThatSaysSo) {
    const auto factor = LobeFactor::create(catalog(), materialOf("phong"), LobeTerm::Distribution);
    ASSERT_FALSE(factor);
    EXPECT_EQ(factor.error().problem, "Phong does not tell a distribution apart");
    EXPECT_TRUE(factorsOf(catalog(), materialOf("lambert")).empty());
    EXPECT_EQ(factorsOf(catalog(), materialOf("cook-torrance")).size(), 3u);
    EXPECT_FALSE(LobeModel::create(catalog(), materialOf("cook-torrance"), LobeTerm::Masking));
}

TEST(LobeFactor, InAPolarPlot_IsALineOfItsOwn) {
    LobeRequest request;
    request.term = LobeTerm::Masking;
    const auto lines = lobeLines(catalog(), materialOf("cook-torrance"), request);
    ASSERT_TRUE(lines);
    EXPECT_EQ(lines->lines.front().name, "masking");
    EXPECT_TRUE(lines->lines.front().isShare);
    request.plot = LobePlot::Albedo;
    EXPECT_FALSE(lobeLines(catalog(), materialOf("cook-torrance"), request));
}

TEST(LobeSolid, OfLambert_IsEvenOverTheWholeHemisphere) {
    const LobeModel model = modelOf(materialOf("lambert", {{"diffuse.color", glm::dvec3(0.5)}}));
    for (const double degrees : {0.0, 50.0, 90.0}) {
        const LobeSolid solid = lobeSolid(model, {degrees * degree, 0.3});
        ASSERT_EQ(solid.f.size(), solid.directions.size());
        for (std::size_t i = 0; i < solid.f.size(); ++i) {
            EXPECT_NEAR(glm::length(solid.directions[i]), 1.0, 1e-12);
            EXPECT_GE(solid.directions[i].z, 0.0);
            if (solid.directions[i].z > 1e-6) { // at the horizon nothing is seen
                EXPECT_NEAR(solid.f[i].x, 0.5 / pi, 1e-9) << degrees;
            }
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

TEST(EnergyRange, OfAnEvenCurve_IsItsValue) {
    const LobeModel model =
        modelOf(materialOf("lambert", {{"diffuse.color", glm::dvec3(0.25, 0.5, 1.0)}}));
    const EnergyRange range = energyRange(albedoCurve(model, 0.0, albedoAngles(10.0)));
    for (const glm::dvec3& each : {range.min, range.mean, range.max}) {
        EXPECT_LT(worst(each, {0.25, 0.5, 1.0}), 1e-5);
    }
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

/// Is a published value of a reflectance for both polarisations.
struct Reflected {
    double degrees;
    double s;
    double p;
};

OpticalInterface clear(double outside, double inside) {
    return {outside, glm::dvec3(inside), glm::dvec3(0.0), false};
}

void expectReflected(const OpticalInterface& media, bool fromInside,
                     std::span<const Reflected> rows, double tolerance) {
    for (const Reflected& row : rows) {
        const PolarisedPoint point = reflectedAt(media, row.degrees * degree, fromInside);
        EXPECT_NEAR(point.s.x, row.s, tolerance) << row.degrees;
        EXPECT_NEAR(point.p.x, row.p, tolerance) << row.degrees;
        EXPECT_NEAR(point.mean().x, 0.5 * (row.s + row.p), tolerance) << row.degrees;
    }
}

// Values of an independent computation with 50 digits.
constexpr Reflected glassFromAir[] = {
    {0, 0.0400000000000000, 0.0400000000000000},
    {15.0000000000000, 0.0438350830799345, 0.0363264512258003},
    {30.0000000000000, 0.0577961054032131, 0.0252491465484300},
    {45.0000000000000, 0.0920133630455244, 0.00846645897894748},
    {56.3099324740202, 0.147928994082840, 0},
    {56.3100000000000, 0.147929458995345, 5.03126437591559e-13},
    {60.0000000000000, 0.176571488082841, 0.00180193752158504},
    {70.0000000000000, 0.299594677933327, 0.0424903928016021},
    {75.0000000000000, 0.399356027000395, 0.106765098980244},
    {80.0000000000000, 0.538594905749581, 0.236813803633365},
    {85.0000000000000, 0.732345478710801, 0.493253811818853},
    {89.0000000000000, 0.939472161295008, 0.868897738265371},
    {89.9000000000000, 0.993775180909546, 0.986048572929313},
};

constexpr Reflected airFromGlass[] = {
    {0, 0.0400000000000000, 0.0400000000000000},
    {10, 0.0438878699608064, 0.0362780483493337},
    {20, 0.0590632255245005, 0.0243938108567440},
    {30, 0.105772791145043, 0.00460754344570864},
    {33.69, 0.147927948038646, 2.54704254112717e-12},
    {35, 0.171085866096045, 0.00119011684157906},
    {38, 0.260051777588811, 0.0243105842745208},
    {40, 0.390518108562894, 0.100064300010927},
    {41, 0.530976769560263, 0.228525762364617},
    {41.5, 0.675052696196953, 0.408187286833759},
    {41.7, 0.790896101633652, 0.588425195052702},
    {41.8, 0.930737564893233, 0.850806278106256},
    {41.81, 0.987536267555387, 0.972174462697398},
    {41.8103, 0.997275884437224, 0.993881169279761},
    {41.8104, 1.00000000000000, 1.00000000000000},
    {41.82, 1.00000000000000, 1.00000000000000},
    {42, 1.00000000000000, 1.00000000000000},
    {45, 1.00000000000000, 1.00000000000000},
    {60, 1.00000000000000, 1.00000000000000},
    {80, 1.00000000000000, 1.00000000000000},
    {89.9, 1.00000000000000, 1.00000000000000},
};

constexpr Reflected waterFromAir[] = {
    {0, 0.0203731878419714, 0.0203731878419714},   {30, 0.0309339908899781, 0.0119389408368869},
    {45, 0.0529889051298880, 0.00280782406686427}, {60, 0.115067934112644, 0.00431390423766136},
    {80, 0.457017433035840, 0.238815980883526},    {89.9, 0.992110698198714, 0.986024532761645},
};

constexpr Reflected diamondFromAir[] = {
    {0, 0.171968832523159, 0.171968832523159},   {30, 0.215188989041736, 0.131731438148490},
    {45, 0.282452754673401, 0.0797795586225927}, {60, 0.406054343500291, 0.0164685322988894},
    {80, 0.729543968893914, 0.137085339917148},  {89.9, 0.996832322816640, 0.981635992992984},
};

constexpr Reflected airFromDiamond[] = {
    {0, 0.171968832523159, 0.171968832523159},     {10, 0.200601551894463, 0.144670100790007},
    {20, 0.363471369768891, 0.0334089587265413},   {22.5, 0.502799792901124, 7.90488194186933e-6},
    {24, 0.717073991337303, 0.120521595888655},    {24.4, 0.904478879394498, 0.553974544225933},
    {24.43, 0.951490244312489, 0.747523043292414}, {24.44, 1.00000000000000, 1.00000000000000},
    {24.5, 1.00000000000000, 1.00000000000000},    {30, 1.00000000000000, 1.00000000000000},
};

/// Is the reflectance of a metal for one colour of light.
struct MetalReflected {
    double index;
    double extinction;
    Reflected reflected;
};

constexpr MetalReflected metals[] = {
    {0.143119, 3.98316, {0, 0.966662793436669, 0.966662793436669}},
    {0.143119, 3.98316, {30, 0.971285251783972, 0.961514778173793}},
    {0.143119, 3.98316, {45, 0.976669657364470, 0.953883619616431}},
    {0.143119, 3.98316, {60, 0.983569659888345, 0.940813971687380}},
    {0.143119, 3.98316, {80, 0.994300302229595, 0.932075340287035}},
    {0.143119, 3.98316, {85, 0.997137102415821, 0.955011368617099}},
    {0.143119, 3.98316, {89.9, 0.999942601655193, 0.998974053782856}},
    {0.374957, 2.38572, {0, 0.802190051310130, 0.802190051310130}},
    {0.374957, 2.38572, {30, 0.829428425087376, 0.774190129665723}},
    {0.374957, 2.38572, {45, 0.860944441610103, 0.741225331539332}},
    {0.374957, 2.38572, {60, 0.901330243244186, 0.707752931835755}},
    {0.374957, 2.38572, {80, 0.965121299673292, 0.786213804241346}},
    {0.374957, 2.38572, {85, 0.982367701800901, 0.874938917729202}},
    {0.374957, 2.38572, {89.9, 0.999644014112273, 0.997229915259420}},
    {1.44248, 1.60322, {0, 0.324050549666151, 0.324050549666151}},
    {1.44248, 1.60322, {30, 0.381568826050025, 0.270643452026071}},
    {1.44248, 1.60322, {45, 0.460071776940802, 0.211666039937467}},
    {1.44248, 1.60322, {60, 0.581798817245309, 0.160398708422699}},
    {1.44248, 1.60322, {80, 0.830396731688340, 0.352914957725283}},
    {1.44248, 1.60322, {85, 0.911043539177822, 0.582558921637022}},
    {1.44248, 1.60322, {89.9, 0.998136863327281, 0.989132907708677}},
    {0.200438, 3.91295, {0, 0.952140578099502, 0.952140578099502}},
    {0.200438, 3.91295, {30, 0.958743646092303, 0.944810903127076}},
    {0.200438, 3.91295, {45, 0.966447062828242, 0.934019925249336}},
    {0.200438, 3.91295, {60, 0.976339266501278, 0.915789372608641}},
    {0.200438, 3.91295, {80, 0.991773998427316, 0.905080432718903}},
    {0.200438, 3.91295, {85, 0.995865637242296, 0.937287796246907}},
    {0.200438, 3.91295, {89.9, 0.999917058775348, 0.998562303142120}},
    {0.924033, 2.45285, {0, 0.619675966531721, 0.619675966531721}},
    {0.924033, 2.45285, {30, 0.664893235707892, 0.574014139399530}},
    {0.924033, 2.45285, {45, 0.720170675431835, 0.518645801751946}},
    {0.924033, 2.45285, {60, 0.795540650566071, 0.456117351308942}},
    {0.924033, 2.45285, {80, 0.924558588382904, 0.556326508900105}},
    {0.924033, 2.45285, {85, 0.961444275416824, 0.720693756356888}},
    {0.924033, 2.45285, {89.9, 0.999213277743132, 0.993215196914675}},
    {1.10221, 2.14219, {0, 0.510578334603532, 0.510578334603532}},
    {1.10221, 2.14219, {30, 0.563928237966443, 0.458413216328563}},
    {1.10221, 2.14219, {45, 0.631075462069465, 0.398256238826188}},
    {1.10221, 2.14219, {60, 0.725826532216315, 0.337878865675876}},
    {1.10221, 2.14219, {80, 0.896021975141425, 0.480005067342575}},
    {1.10221, 2.14219, {85, 0.946457808733074, 0.671351693428674}},
    {1.10221, 2.14219, {89.9, 0.998899142223419, 0.991842138160347}},
    {1.65746, 9.22387, {0, 0.928047478337309, 0.928047478337309}},
    {1.65746, 9.22387, {30, 0.937461008714320, 0.917352986330465}},
    {1.65746, 9.22387, {45, 0.948704591751311, 0.900040402410022}},
    {1.65746, 9.22387, {60, 0.963498599994511, 0.863833594740646}},
    {1.65746, 9.22387, {80, 0.987184230222432, 0.724405232483640}},
    {1.65746, 9.22387, {85, 0.993547759436089, 0.702143581813643}},
    {1.65746, 9.22387, {89.9, 0.999870386394132, 0.988434816121911}},
    {0.880369, 6.26952, {0, 0.917804466562554, 0.917804466562554}},
    {0.880369, 6.26952, {30, 0.928620650773943, 0.905618545442508}},
    {0.880369, 6.26952, {45, 0.941497418528934, 0.886417389096647}},
    {0.880369, 6.26952, {60, 0.958390984515730, 0.848566558452147}},
    {0.880369, 6.26952, {80, 0.985386552936063, 0.751637653441189}},
    {0.880369, 6.26952, {85, 0.992640442197440, 0.786239822356546}},
    {0.880369, 6.26952, {89.9, 0.999852101222825, 0.993801270788645}},
    {0.521229, 4.837, {0, 0.918908646630200, 0.918908646630200}},
    {0.521229, 4.837, {30, 0.929730688952399, 0.906819284325112}},
    {0.521229, 4.837, {45, 0.942531389453981, 0.888365420106051}},
    {0.521229, 4.837, {60, 0.959215979263364, 0.854452788239949}},
    {0.521229, 4.837, {80, 0.985705863887626, 0.802832336052973}},
    {0.521229, 4.837, {85, 0.992803145880233, 0.853641572018904}},
    {0.521229, 4.837, {89.9, 0.999855391456136, 0.996298192018737}},
};

/// Is the index of the clear medium that reflects so much facing the surface.
struct IndexOfF0 {
    double f0;
    double index;
};

constexpr IndexOfF0 indices[] = {
    {0.02, 1.32943133925982}, {0.04, 1.50000000000000}, {0.05, 1.57601431105259},
    {0.08, 1.78878850537961}, {0.1, 1.92495059114853},  {0.25, 3.00000000000000},
    {0.5, 5.82842712474619},  {0.9, 37.9736659610103},  {0.95, 77.9871773792359},
    {0.99, 397.997487421324},
};

TEST(FresnelCurve, OfClearMedia_HasThePublishedValuesFromBothSides) {
    constexpr double tolerance = 2e-14;
    expectReflected(clear(1.0, 1.5), false, glassFromAir, tolerance);
    expectReflected(clear(1.0, 1.333), false, waterFromAir, tolerance);
    expectReflected(clear(1.0, 2.417), false, diamondFromAir, tolerance);
    // Beside the critical angle a rounding of the angle is many of the reflectance.
    expectReflected(clear(1.0, 1.5), true, airFromGlass, 1e-10);
    expectReflected(clear(1.0, 2.417), true, airFromDiamond, 1e-10);
}

TEST(FresnelCurve, OfMetals_HasThePublishedValues) {
    for (const MetalReflected& row : metals) {
        const OpticalInterface media{1.0, glm::dvec3(row.index), glm::dvec3(row.extinction), false};
        expectReflected(media, false, {&row.reflected, 1}, 2e-14);
    }
}

TEST(FresnelCurve, OfAReflectance_KnowsTheIndexBehindIt) {
    const Block& schlick = *catalog().find(kinds::fresnel, "schlick");
    for (const IndexOfF0& row : indices) {
        const auto media = interfaceOf(schlick, {{"f0", glm::dvec3(row.f0)}});
        ASSERT_TRUE(media);
        EXPECT_TRUE(media->isFromReflectance);
        EXPECT_NEAR(media->index.x / row.index, 1.0, 1e-13);
    }
}

/// Is a Fresnel block with values, in a model's slot.
Material withFresnel(const std::string& id, const Values& values) {
    Material material = materialOf("cook-torrance");
    material.parts["fresnel"] = {id, 1, values, nlohmann::json::object()};
    return material;
}

TEST(FresnelCurve, OfGlass_ReflectsNothingAtBrewstersAngleAndAllBeyondTheCriticalOne) {
    const auto curves = fresnelCurves(
        catalog(), withFresnel("dielectric", {{"index.outside", 1.0}, {"index.inside", 1.5}}));
    ASSERT_TRUE(curves);
    EXPECT_NEAR(curves->fromOutside.brewster.x / degree, 56.309932474020213, 1e-12);
    EXPECT_NEAR(curves->fromInside.brewster.x / degree, 33.690067525979787, 1e-12);
    EXPECT_NEAR(curves->fromInside.critical.x / degree, 41.810314895778598, 1e-12);
    EXPECT_NEAR(curves->fromOutside.critical.x / degree, 90.0, 1e-12);
    for (const PolarisedPoint& point : curves->fromInside.points) {
        if (point.angle > curves->fromInside.critical.x + 1e-9) {
            EXPECT_EQ(point.mean().x, 1.0);
        }
    }
    const PolarisedPoint dark = reflectedAt(*curves->media, curves->fromOutside.brewster.x);
    EXPECT_LT(dark.p.x, 1e-30);
}

TEST(FresnelCurve, OfACoarseLevel_StandsBesideTheExactOne) {
    Material material = withFresnel("dielectric", {{"index.inside", 1.5}});
    material.accuracy["reflectance.clear"] = "schlick";
    const auto curves = fresnelCurves(catalog(), material);
    ASSERT_TRUE(curves);
    double apart = 0.0;
    for (const FresnelPoint& point : curves->term) {
        EXPECT_NEAR(point.exact.x, reflectedAt(*curves->media, point.angle).mean().x, 1e-14);
        apart = std::max(apart, std::abs(point.chosen.x - point.exact.x));
    }
    EXPECT_NEAR(apart, 0.036, 0.001); // as the level's text says
}

TEST(FresnelCurve, IsFiniteForEveryEdgeCase) {
    for (const Block* block : catalog().ofKind(kinds::fresnel)) {
        for (const EvalCase& variant : sweepVariants(catalog(), *block)) {
            for (const EvalCase& row : sweepRows(variant)) {
                const auto curves =
                    fresnelCurves(catalog(), withFresnel(block->id, row.block.values));
                ASSERT_TRUE(curves) << block->id;
                for (const auto* side : {&curves->fromOutside, &curves->fromInside}) {
                    for (const PolarisedPoint& point : side->points) {
                        EXPECT_TRUE(std::isfinite(glm::dot(point.s, point.p))) << block->id;
                        EXPECT_GE(std::min({point.s.x, point.p.x}), 0.0) << block->id;
                        EXPECT_LE(std::max({point.s.x, point.p.x}), 1.0) << block->id;
                    }
                }
            }
        }
    }
}

TEST(FresnelCurve, OfAMaterialWithoutOne_SaysSo) {
    const auto curves = fresnelCurves(catalog(), materialOf("lambert"));
    ASSERT_FALSE(curves);
    EXPECT_EQ(curves.error().problem, "the material has no Fresnel term");
}

TEST(ReflectanceTable, OfEveryModel_IsOverTheNumbersThatDecideIt) {
    for (const Block* block : catalog().ofKind(kinds::models)) {
        const auto table =
            reflectanceTable(catalog(), defaultMaterial(*block), LobeTerm::Whole, 32);
        // Without a file the measured one is matte.
        const bool factors = block->id == "lambert" || block->id == "measured" ||
                             block->id == "minnaert" || block->id == "lommel-seeliger" ||
                             block->id == "heidrich-seidel";
        EXPECT_EQ(table.has_value(), factors) << block->id;
        if (table) {
            EXPECT_EQ(table->axes, block->id == "heidrich-seidel" ? TableAxes::TangentCosines
                                                                  : TableAxes::NormalCosines)
                << block->id;
        }
    }
}

TEST(ReflectanceTable, ReadBetweenTexels_IsAsNearAsItSays) {
    const auto checked = [](const Material& material, LobeTerm term) {
        const auto table = reflectanceTable(catalog(), material, term, 64);
        ASSERT_TRUE(table);
        const LobeModel model = modelOf(material, term);
        double mean = 0.0;
        constexpr int steps = 50;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                // Directions that are not in one plane, other than those that were tabled.
                const double a = std::acos((i + 0.3) / steps);
                const double b = std::acos((j + 0.6) / steps);
                const glm::dvec3 l(std::sin(a) * 0.6, std::sin(a) * 0.8, std::cos(a));
                const glm::dvec3 v(-std::sin(b), 0.0, std::cos(b));
                mean += worst(table->value(l, v), model.value(l, v)) / (steps * steps);
                EXPECT_LE(worst(table->value(l, v), model.value(l, v)),
                          1.05 * table->maxError + 1e-9);
            }
        }
        EXPECT_LE(mean, 3.0 * table->meanError + 1e-9);
        EXPECT_LT(table->meanError, 0.003);
    };
    checked(materialOf("minnaert", {{"darkening", 1.5}}), LobeTerm::Whole);
    checked(materialOf("lommel-seeliger"), LobeTerm::Whole);
    checked(materialOf("heidrich-seidel"), LobeTerm::Whole);
    checked(materialOf("heidrich-seidel", {{"tangent.angle", 30.0}}), LobeTerm::Highlight);
    checked(materialOf("phong"), LobeTerm::Diffuse);
}

TEST(ReflectanceTable, OfLambert_LosesNothing) {
    const auto table = reflectanceTable(
        catalog(), materialOf("lambert", {{"diffuse.color", glm::dvec3(0.5)}}), LobeTerm::Whole, 8);
    ASSERT_TRUE(table);
    EXPECT_FALSE(table->hasCosine);
    EXPECT_LT(table->maxError, 1e-9);
    EXPECT_NEAR(table->values.front().y, 0.5, 1e-12);
    const std::string code = tableCode(*table, "Lambert");
    EXPECT_NE(code.find("vec2(dot(n, v), nl)"), std::string::npos) << code;
    EXPECT_NE(code.find(".rgb * nl"), std::string::npos) << code;
}

TEST(NoReflectance, IsSaidOfDrawingsAlone) {
    for (const Block* block : catalog().ofKind(kinds::models)) {
        const bool draws = block->id == "gooch" || block->id == "toon" || block->id == "halftone" ||
                           block->id == "hatching";
        EXPECT_EQ(!whyNoReflectance(*block).empty(), draws) << block->id;
    }
}

} // namespace
} // namespace patina::physics::lobe_test
