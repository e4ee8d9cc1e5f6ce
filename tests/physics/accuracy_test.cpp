// SPDX-License-Identifier: GPL-3.0-or-later
// How far each cheaper level of an accuracy choice is from the exact one. The errors were found
// apart from this program, in quadruple precision on dense grids, and are met to a twentieth.
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "physics_cases.h"

namespace patina::physics::accuracy_test {
namespace {

constexpr int steps = 2000;
constexpr double closeness = 0.05;

void expectAbout(double found, double published) {
    EXPECT_NEAR(found, published, closeness * published);
}

double largest(const std::function<double(double)>& difference) {
    double worst = 0.0;
    for (int i = 0; i <= steps; ++i) {
        worst = std::max(worst, std::abs(difference(static_cast<double>(i) / steps)));
    }
    return worst;
}

/// A highlight alone, seen at the cosine c from where it is brightest.
double highlight(const Subject& model, double c) {
    const glm::dvec3 v{std::sqrt((1.0 - c) * (1.0 + c)), 0.0, c};
    return model.shade(geometry({0.0, 0.0, 1.0}, v)).x;
}

Subject power(const std::string& level, double exponent) {
    return {"models",
            "phong",
            {{"diffuse.color", black}, {"specular.color", white}, {"shininess", exponent}},
            {{"power", level}}};
}

double powerError(const std::string& level, double exponent) {
    const Subject exact = power("exact", exponent);
    const Subject cheap = power(level, exponent);
    return largest([&](double c) { return highlight(cheap, c) - highlight(exact, c); });
}

TEST(SchlickFraction, OfExponent64AtNineTenths_IsAHundredTimesThePower) {
    EXPECT_NEAR(highlight(power("rational", 64.0), 0.9), 0.1233, 5e-5);
    EXPECT_NEAR(highlight(power("exact", 64.0), 0.9), 0.0012, 5e-5);
}

TEST(SchlickFraction, OfAPower_ErrsByAFifth) {
    expectAbout(powerError("rational", 5.0), 0.155);
    expectAbout(powerError("rational", 32.0), 0.196);
    expectAbout(powerError("rational", 200.0), 0.202);
}

TEST(SphericalGaussian, OfAPower_ErrsTheLessTheSharperItIs) {
    expectAbout(powerError("gaussian", 5.0), 5.8e-2);
    expectAbout(powerError("gaussian", 32.0), 8.6e-3);
    expectAbout(powerError("gaussian", 200.0), 1.4e-3);
}

/// Returns the highlight at an h halfway between the light and the viewer, or on both.
double halfHighlight(const Subject& model, double c) {
    const glm::dvec3 both{std::sqrt((1.0 - c) * (1.0 + c)), 0.0, c};
    return model.shade(geometry(both, both)).x;
}

double halfError(const std::string& id, const Values& values, const AccuracyLevels& levels) {
    Values all{{"diffuse.color", black}, {"specular.color", white}};
    all.insert(values.begin(), values.end());
    const Subject exact("models", id, all);
    const Subject cheap("models", id, all, levels);
    return largest([&](double c) { return halfHighlight(cheap, c) - halfHighlight(exact, c); });
}

TEST(BlinnPhongPower, ByEachLevel_ErrsAsOfPhong) {
    expectAbout(halfError("blinn-phong", {{"shininess", 32.0}}, {{"power", "gaussian"}}), 8.6e-3);
    expectAbout(halfError("blinn-phong", {{"shininess", 32.0}}, {{"power", "rational"}}), 0.196);
}

TEST(GaussianAngle, ByThePolynomial_ErrsLittle) {
    expectAbout(halfError("gaussian", {{"width", 0.4}}, {{"angle", "polynomial"}}), 3.6e-5);
}

TEST(GaussianAngle, TakenForSmall_ErrsAsWideAsItIs) {
    expectAbout(halfError("gaussian", {{"width", 0.4}}, {{"angle", "small"}}), 7.3e-3);
    expectAbout(halfError("gaussian", {{"width", 1.5}}, {{"angle", "small"}}), 7.7e-2);
}

double fresnelError(const std::string& id, const Values& values, const AccuracyLevels& levels) {
    const Subject exact("fresnel", id, values);
    const Subject cheap("fresnel", id, values, levels);
    return largest([&](double c) { return cheap.reflectance(c) - exact.reflectance(c); });
}

TEST(SchlickFresnel, OfGlass_ErrsMostNear85Degrees) {
    const Values glass{{"index.inside", 1.5}};
    const Subject exact("fresnel", "dielectric", glass);
    const Subject cheap("fresnel", "dielectric", glass, {{"reflectance.clear", "schlick"}});
    const double c = direction(85.0, 0.0).z;
    EXPECT_NEAR(cheap.reflectance(c) - exact.reflectance(c), 0.036, 5e-4);
    EXPECT_NEAR(fresnelError("dielectric", glass, {{"reflectance.clear", "schlick"}}), 0.036, 5e-4);
}

TEST(SchlickFresnel, OfWaterAndDiamond_ErrsMore) {
    const AccuracyLevels schlick{{"reflectance.clear", "schlick"}};
    expectAbout(fresnelError("dielectric", {{"index.inside", 1.33}}, schlick), 0.060);
    expectAbout(fresnelError("dielectric", {{"index.inside", 2.4}}, schlick), 0.074);
}

TEST(SchlickFresnel, ByAnExponential_ErrsALittleMore) {
    const AccuracyLevels fitted{{"reflectance.clear", "exponential"}};
    expectAbout(fresnelError("dielectric", {{"index.inside", 1.33}}, fitted), 0.062);
    expectAbout(fresnelError("dielectric", {{"index.inside", 1.5}}, fitted), 0.039);
    expectAbout(fresnelError("dielectric", {{"index.inside", 2.4}}, fitted), 0.076);
}

TEST(SchlickFresnel, FromInside_ReflectsAllBeyondTheCriticalAngle) {
    for (const char* level : {"schlick", "exponential"}) {
        const Subject inside("fresnel", "dielectric",
                             {{"index.outside", 1.5}, {"index.inside", 1.0}},
                             {{"reflectance.clear", level}});
        EXPECT_NEAR(inside.reflectance(direction(42.0, 0.0).z), 1.0, 1e-12);
        EXPECT_LT(inside.reflectance(direction(40.0, 0.0).z), 0.3);
    }
}

TEST(SchlickFresnel, OfEqualIndices_ReflectsNothing) {
    for (const char* level : {"schlick", "exponential"}) {
        const Subject none("fresnel", "dielectric", {{"index.outside", 1.5}, {"index.inside", 1.5}},
                           {{"reflectance.clear", level}});
        EXPECT_EQ(none.reflectance(0.01), 0.0);
    }
}

TEST(SchlickFresnel, OfPolarisedLight_IsExact) {
    EXPECT_EQ(fresnelError("dielectric", {{"polarisation", std::string("s")}},
                           {{"reflectance.clear", "schlick"}}),
              0.0);
}

double metalError(double eta, double k, const char* level) {
    return fresnelError("conductor", {{"eta", glm::dvec3(eta)}, {"k", glm::dvec3(k)}},
                        {{"reflectance", level}});
}

TEST(MetalFresnel, BySchlick_LacksTheDipBeforeTheRim) {
    expectAbout(metalError(0.155, 3.6, "schlick"), 1.6e-2);
    expectAbout(metalError(1.5, 7.5, "schlick"), 0.127);
    expectAbout(metalError(2.9, 3.1, "schlick"), 0.177);
    expectAbout(metalError(1.38, 1.92, "schlick"), 1.8e-2);
}

TEST(MetalFresnel, ByTheHighIndexForm_ErrsByHalfAHundredth) {
    expectAbout(metalError(0.155, 3.6, "high-index"), 2.0e-3);
    expectAbout(metalError(1.5, 7.5, "high-index"), 2.2e-3);
    expectAbout(metalError(2.9, 3.1, "high-index"), 5.0e-3);
    expectAbout(metalError(1.38, 1.92, "high-index"), 5.8e-3);
}

TEST(F0Fresnel, BySchlick_ErrsAsForGlass) {
    expectAbout(
        fresnelError("blinn-f0", {{"f0", glm::dvec3(0.04)}}, {{"reflectance.f0", "schlick"}}),
        0.036);
}

/// The largest relative difference of two functions of light and viewer.
double largestRatio(const std::function<double(double, double)>& cheap,
                    const std::function<double(double, double)>& exact) {
    double worst = 0.0;
    for (int i = 1; i <= 300; ++i) {
        for (int k = 1; k <= 300; ++k) {
            const double nl = i / 300.0;
            const double nv = k / 300.0;
            worst = std::max(worst, std::abs(cheap(nl, nv) / exact(nl, nv) - 1.0));
        }
    }
    return worst;
}

/// The visibility of a Cook-Torrance model as a ratio: all else is the same.
double maskingError(const Values& values, const char* level) {
    Values all{{"diffuse.color", black}, {"specular.color", white}};
    all.insert(values.begin(), values.end());
    const Subject exact("models", "cook-torrance", all);
    const Subject cheap("models", "cook-torrance", all, {{"shadowing", level}});
    const Subject mirror("fresnel", "constant", {{"f0", white}});
    const auto by = [&mirror](const Subject& model) {
        return [&model, &mirror](double nl, double nv) {
            const glm::dvec3 l{std::sqrt(1.0 - nl * nl), 0.0, nl};
            const glm::dvec3 v{-std::sqrt(1.0 - nv * nv), 0.0, nv};
            return model.shade(geometry(l, v), mirror.filler()).x;
        };
    };
    return largestRatio(by(cheap), by(exact));
}

TEST(SmithMasking, ByWalter_IsWithinAHundredthForBothDirections) {
    const double error = maskingError({{"masking", "smith"}, {"roughness", 0.3}}, "walter");
    EXPECT_GT(error, 0.005);
    EXPECT_LT(error, 2.1 * 0.0063);
}

TEST(SmithMasking, OfGgxBySchlick_ErrsLessByHeightAsHammonDoes) {
    const auto error = [](const std::string& masking, double width) {
        return maskingError({{"distribution", "ggx"}, {"masking", masking}, {"roughness", width}},
                            "schlick");
    };
    expectAbout(error("smith-correlated", 0.3), 0.19);
    expectAbout(error("smith-correlated", 0.7), 0.08);
    expectAbout(error("smith", 0.3), 0.25);
}

TEST(SmithMasking, LeftOut_IsRightFacingTheSurface) {
    const Values values{{"diffuse.color", black}, {"masking", "smith-correlated"}};
    const Subject mirror("fresnel", "constant", {{"f0", white}});
    const auto facing = geometry({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
    const Subject exact("models", "cook-torrance", values);
    const Subject none("models", "cook-torrance", values, {{"shadowing", "none"}});
    EXPECT_NEAR(none.shade(facing, mirror.filler()).x, exact.shade(facing, mirror.filler()).x,
                1e-12);
}

double facetError(const char* distribution, double roughness) {
    const Values values{{"diffuse.color", black},
                        {"specular.color", white},
                        {"distribution", std::string(distribution)},
                        {"roughness", roughness}};
    const Subject exact("models", "cook-torrance", values, {{"shadowing", "none"}});
    const Subject cheap("models", "cook-torrance", values,
                        {{"shadowing", "none"}, {"facets", "reduced"}});
    const Subject mirror("fresnel", "constant", {{"f0", white}});
    const auto at = [&mirror](const Subject& model, double c) {
        const glm::dvec3 both{std::sqrt((1.0 - c) * (1.0 + c)), 0.0, c};
        return model.shade(geometry(both, both), mirror.filler()).x / std::max(c, 1e-9);
    };
    return largest([&](double c) { return c > 0.0 ? at(cheap, c) - at(exact, c) : 0.0; }) /
           at(exact, 1.0);
}

TEST(ReducedFacets, OfBeckmann_ErrWithTheFourthPowerOfTheWidth) {
    expectAbout(facetError("beckmann", 0.1), 9.2e-5);
    expectAbout(facetError("beckmann", 0.3), 7.4e-3);
    expectAbout(facetError("beckmann", 0.4), 2.4e-2);
}

TEST(ReducedFacets, OfGgx_AreExact) {
    EXPECT_EQ(facetError("ggx", 0.3), 0.0);
}

/// The largest difference over directions of light and viewer down to cosines of 0.05.
double matteError(const char* form, double roughness, double color, const char* level) {
    const Values values{{"diffuse.color", glm::dvec3(color)},
                        {"form", std::string(form)},
                        {"roughness", roughness}};
    const Subject exact("models", "oren-nayar", values);
    const Subject cheap("models", "oren-nayar", values, {{"matte", level}});
    double worst = 0.0;
    for (double a = 0.0; a <= 87.0; a += 3.0) {
        for (double b = 0.0; b <= 87.0; b += 3.0) {
            for (double turn = 0.0; turn <= 180.0; turn += 15.0) {
                const auto at = geometry(direction(a, 0.0), direction(b, turn));
                worst = std::max(worst, std::abs(cheap.shade(at).x - exact.shade(at).x));
            }
        }
    }
    return worst;
}

TEST(MatteForm, QualitativeForTheFullOnes_ErrsByATenthAndMore) {
    expectAbout(matteError("interreflection", 0.5, 0.8, "qualitative"), 0.035 * std::numbers::pi);
    expectAbout(matteError("full", 0.5, 0.8, "qualitative"), 0.168);
}

TEST(MatteForm, FujiiForEon_ErrsByATenth) {
    expectAbout(matteError("eon", 0.5, 0.8, "fujii"), 0.034 * std::numbers::pi);
}

TEST(MatteForm, WithFittedLosses_IsCloseToEon) {
    EXPECT_LT(matteError("eon", 1.0, 1.0, "fit"), 7e-4);
    EXPECT_GT(matteError("eon", 1.0, 1.0, "fit"), 5e-5);
}

TEST(MatteForm, OfOneBounceWithoutAngles_StaysAsItIs) {
    for (const char* level : {"fit", "qualitative", "fujii"}) {
        EXPECT_EQ(matteError("qualitative-033", 0.5, 0.8, level), 0.0) << level;
        EXPECT_EQ(matteError("fujii", 0.5, 0.8, level), 0.0) << level;
    }
}

TEST(StraussTerms, ByTheCosine_ErrByAnEighth) {
    // Without smoothness the highlight is k times the product of the terms on the mirror direction.
    const Values values{{"diffuse.color", black}, {"specular.color", white}, {"smoothness", 0.0},
                        {"metalness", 0.0},       {"transparency", 0.0},     {"k", 0.1}};
    const Subject exact("models", "strauss", values);
    const Subject cheap("models", "strauss", values, {{"terms", "cosine"}});
    const auto mirrored = [](const Subject& model, double c) {
        const double s = std::sqrt((1.0 - c) * (1.0 + c));
        return model.shade(geometry({s, 0.0, c}, {-s, 0.0, c})).x / 0.1;
    };
    const double worst =
        largest([&](double c) { return c > 0.0 ? mirrored(cheap, c) - mirrored(exact, c) : 0.0; });
    expectAbout(worst, 0.13);
}

TEST(StraussTerms, OfAnyPairByTheCosine_ErrByNoMoreThanIsStated) {
    const Values values{{"diffuse.color", black}, {"specular.color", white}, {"smoothness", 0.0},
                        {"metalness", 0.0},       {"transparency", 0.0},     {"k", 0.1}};
    const Subject exact("models", "strauss", values);
    const Subject cheap("models", "strauss", values, {{"terms", "cosine"}});
    double worst = 0.0;
    for (double a = 1.5; a < 90.0; a += 0.5) {
        for (const double b : {45.0, 80.0, 89.0, 89.3, 89.5}) {
            const auto at = geometry(direction(a, 0.0), direction(b, 180.0));
            const double lobe = std::pow(std::cos((a - b) * std::numbers::pi / 180.0), 3.0);
            if (lobe > 0.05) {
                worst = std::max(worst, std::abs(cheap.shade(at).x - exact.shade(at).x) / lobe);
            }
        }
    }
    EXPECT_LE(worst, 0.1 * 0.14);
    EXPECT_GT(worst, 0.1 * 0.125);
}

TEST(AshikhminShirleyFall, AsAGaussian_ErrsAsOfPhong) {
    const auto error = [](double e) {
        const Values values{{"diffuse.color", black},
                            {"specular.color", white},
                            {"shininess.x", e},
                            {"shininess.y", e}};
        const Subject mirror("fresnel", "constant", {{"f0", white}});
        const Subject exact("models", "ashikhmin-shirley", values);
        const Subject cheap("models", "ashikhmin-shirley", values, {{"falloff", "gaussian"}});
        return largest([&](double c) {
                   const glm::dvec3 both{std::sqrt((1.0 - c) * (1.0 + c)), 0.0, c};
                   const auto at = geometry(both, both);
                   return cheap.shade(at, mirror.filler()).x - exact.shade(at, mirror.filler()).x;
               }) /
               (0.125 * (e + 1.0));
    };
    expectAbout(error(32.0), 8.6e-3);
    expectAbout(error(200.0), 1.4e-3);
}

TEST(LafortuneFall, AsAGaussian_ErrsAsOfPhong) {
    const Values values{{"diffuse.color", black},      {"lobe1.color", white},
                        {"lobe1.x", glm::dvec3(-1.0)}, {"lobe1.y", glm::dvec3(-1.0)},
                        {"lobe1.z", glm::dvec3(1.0)},  {"lobe1.exponent", glm::dvec3(32.0)}};
    const Subject exact("models", "lafortune", values);
    const Subject cheap("models", "lafortune", values, {{"falloff", "gaussian"}});
    const double peak = highlight(exact, 1.0);
    expectAbout(
        largest([&](double c) { return (highlight(cheap, c) - highlight(exact, c)) / peak; }),
        8.6e-3);
}

/// The largest error of the limit over the largest value of the series, at one roughness.
double limitError(double g) {
    const double peak = call("wave_series", {g, 0.0, 20.0, 8.0, 8.0})[0];
    return largest([g, peak](double u) {
        const double x = 8.0 * g * u;
        return (call("wave_limit", {g, x})[0] - call("wave_series", {g, x, 20.0, 8.0, 8.0})[0]) /
               peak;
    });
}

TEST(WaveLimit, AtAnyRoughness_IsWithinAHundredthOfThePeak) {
    for (const double g : {0.01, 0.5, 2.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 15.0}) {
        EXPECT_LE(limitError(g), 0.014) << g;
    }
}

TEST(WaveLimit, OfRoughSurfaces_IsTheSeries) {
    for (const double g : {30.0, 100.0, 1000.0, 1e5}) {
        EXPECT_LE(limitError(g), 2e-4 * (30.0 / g)) << g;
    }
}

/// The largest share of the series by which the limit is off, where `least` of the peak is left.
double limitShareError(double g, double minShare) {
    const double peak = call("wave_series", {g, 0.0, 20.0, 8.0, 8.0})[0];
    return largest([&](double u) {
        const double value = call("wave_series", {g, 30.0 * g * u, 20.0, 8.0, 8.0})[0];
        return value < minShare * peak ? 0.0
                                       : call("wave_limit", {g, 30.0 * g * u})[0] / value - 1.0;
    });
}

TEST(WaveLimit, WhereAHighlightIsSeen_IsCloseToItsOwnValue) {
    for (const double g : {0.01, 0.5, 2.0, 4.0, 5.0, 6.0, 6.75, 7.0, 7.25, 8.0, 15.0, 100.0}) {
        EXPECT_LE(limitShareError(g, 0.1), 0.0215) << g;
        EXPECT_LE(limitShareError(g, 0.01), 0.0565) << g;
    }
}

TEST(WaveLimit, InTheDarkAroundAHighlight_LosesWhatIsLeft) {
    EXPECT_GT(limitShareError(8.0, 1e-4), 0.9);
}

TEST(CoatedBase, AsLambert_LosesTheEighthOfThePaper) {
    const Values values{{"diffuse.color", white}, {"specular.color", glm::dvec3(1.0)}};
    const Subject coat = schlickFrom(0.05);
    const auto facing = geometry({0.0, 0.0, 1.0}, direction(0.0, 0.0));
    const Subject exact("models", "ashikhmin-shirley", values);
    const Subject cheap("models", "ashikhmin-shirley", values, {{"base", "lambert"}});
    EXPECT_NEAR(exact.shade(facing, coat.filler()).x - cheap.shade(facing, coat.filler()).x, 0.0854,
                1e-4);
}

} // namespace
} // namespace patina::physics::accuracy_test
