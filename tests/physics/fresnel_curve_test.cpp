// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "lobe_cases.h"
#include "measure/lobe/fresnel_curve.h"
#include "measure/stability/sweep_cases.h"

namespace patina::physics::fresnel_curve_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

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

} // namespace
} // namespace patina::physics::fresnel_curve_test
