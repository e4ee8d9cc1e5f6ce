// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "physics_cases.h"

namespace patina::physics::fresnel_values_test {
namespace {

constexpr double rounding = 1e-12;

Subject conductor(double eta, double k, double outside = 1.0) {
    return {"fresnel",
            "conductor",
            {{"eta", glm::dvec3(eta)}, {"k", glm::dvec3(k)}, {"index.outside", outside}}};
}

Subject dielectric(double outside, double inside) {
    return {"fresnel", "dielectric", {{"index.outside", outside}, {"index.inside", inside}}};
}

/// Returns the index of a clear material by constants at one wavelength in nm, from how much it
/// reflects facing the light.
double indexByConstants(Values values, double wavelength) {
    values["wavelength"] = glm::dvec3(wavelength);
    const double r = std::sqrt(Subject("fresnel", "dispersive", values).reflectance(1.0));
    return (1.0 + r) / (1.0 - r);
}

/// Returns the constants of water at 20 degrees (Daimon and Masumura, Appl. Opt. 46, 2007).
Values water() {
    return {{"sellmeier.b", glm::dvec3(0.5684027565, 0.1726177391, 0.02086189578)},
            {"sellmeier.c", glm::dvec3(0.005101829712, 0.01821153936, 0.02620722293)},
            {"sellmeier.b4", 0.1130748688},
            {"sellmeier.c4", 10.69792721},
            {"temperature", 20.0},
            {"temperature.measured", 20.0},
            {"temperature.slope", -1e-4}};
}

TEST(DispersiveFresnel, OfBk7_HasTheIndicesOfItsDataSheet) {
    const Values bk7{{"sellmeier.b", glm::dvec3(1.03961212, 0.231792344, 1.01046945)},
                     {"sellmeier.c", glm::dvec3(0.00600069867, 0.0200179144, 103.560653)},
                     {"temperature", 22.0},
                     {"temperature.measured", 22.0}};
    for (const auto& [wavelength, index] :
         {std::pair(435.8343, 1.52668), std::pair(486.1327, 1.52238), std::pair(587.5618, 1.51680),
          std::pair(656.2725, 1.51432), std::pair(1013.98, 1.50731)}) {
        EXPECT_NEAR(indexByConstants(bk7, wavelength), index, 1e-5) << wavelength;
    }
}

/// Returns the index of water of a temperature in degrees and a density in kg/m^3 by the release on
/// the refractive index of ordinary water substance of the International Association for the
/// Properties of Water and Steam (IAPWS R9-97; A. H. Harvey, J. S. Gallagher and J. M. H. Levelt
/// Sengers, J. Phys. Chem. Ref. Data 27, 1998): Lorentz's and Lorenz's function by density,
/// temperature and wavelength.
double publishedIndexOfWater(double nm, double degrees, double density) {
    const double t = (degrees + 273.15) / 273.15;
    const double r = density / 1000.0;
    const double l2 = std::pow(nm / 589.0, 2.0);
    const double uv2 = 0.2292020 * 0.2292020;
    const double ir2 = 5.432937 * 5.432937;
    const double a = r * (0.244257733 + 9.74634476e-3 * r - 3.73234996e-3 * t +
                          2.68678472e-4 * l2 * t + 1.58920570e-3 / l2 + 2.45934259e-3 / (l2 - uv2) +
                          0.900704920 / (l2 - ir2) - 1.66626219e-2 * r * r);
    return std::sqrt((2.0 * a + 1.0) / (1.0 - a));
}

TEST(DispersiveFresnel, OfWater_HasItsPublishedIndicesAcrossVisibleLight) {
    // What the release itself lists for 0.1 MPa and 0 degrees, of the density 999.843 kg/m^3.
    EXPECT_NEAR(publishedIndexOfWater(226.5, 0.0, 999.843), 1.394527, 1e-6);
    EXPECT_NEAR(publishedIndexOfWater(589.0, 0.0, 999.843), 1.334344, 1e-6);
    for (const double nm :
         {404.656, 435.8343, 486.1327, 546.074, 587.5618, 632.8, 656.2725, 706.52}) {
        EXPECT_NEAR(indexByConstants(water(), nm), publishedIndexOfWater(nm, 20.0, 998.207), 1e-5)
            << nm;
    }
    // The sodium line against air, 1.33299 (Tilton and Taylor, J. Res. NBS 20, 1938).
    EXPECT_NEAR(indexByConstants(water(), 589.3) / 1.000272, 1.33299, 1e-5);
}

/// Warm water is thinner, which is what changes its index.
TEST(DispersiveFresnel, OfWater_FallsWithItsDensity) {
    for (const auto& [degrees, density] :
         {std::pair(15.0, 999.103), std::pair(25.0, 997.047), std::pair(30.0, 995.650)}) {
        Values warm = water();
        warm["temperature"] = degrees;
        const double change = publishedIndexOfWater(587.5618, degrees, density) -
                              publishedIndexOfWater(587.5618, 20.0, 998.207);
        EXPECT_NEAR(indexByConstants(warm, 587.5618) - indexByConstants(water(), 587.5618), change,
                    1.5e-4);
    }
}

TEST(DispersiveFresnel, OfWater_HasItsIndexAndDispersionAndFallsWithWarmth) {
    // By refractiveindex.info 1.3334 at the line d, and Abbe's number 55.76.
    const double d = indexByConstants(water(), 587.5618);
    EXPECT_NEAR(d, 1.3334, 5e-5);
    const double spread = indexByConstants(water(), 486.1327) - indexByConstants(water(), 656.2725);
    EXPECT_NEAR((d - 1.0) / spread, 55.76, 0.02);
    Values warm = water();
    warm["temperature"] = 30.0;
    EXPECT_NEAR(indexByConstants(warm, 587.5618), d - 1e-3, 1e-12);
}

/// Returns the index of a clear material of one number, from how much it reflects facing the light.
double indexOf(const Values& values) {
    const double r = std::sqrt(Subject("fresnel", "dielectric", values).reflectance(1.0));
    return (1.0 + r) / (1.0 - r);
}

TEST(Dielectric, AtATemperatureThatChangesNothing_HasItsIndex) {
    const Values plain{{"index.inside", 1.4567}};
    const auto packedOf = [](const Values& values) {
        return Subject("fresnel", "dielectric", values).parameters;
    };
    for (const Values& changed :
         {Values{{"temperature", 80.0}},
          Values{{"temperature.expansion", 1e-3}, {"temperature.slope", 1e-4}},
          Values{{"temperature.expansion", 1e-3},
                 {"temperature", 300.0},
                 {"temperature.measured", 300.0}}}) {
        Values values = plain;
        values.insert(changed.begin(), changed.end());
        EXPECT_EQ(packedOf(values), packedOf(plain));
    }
}

/// Of 1.5 at 25 degrees it is 1.48425 at 60 by the rule for organic liquids, -0.00045 per kelvin.
TEST(Dielectric, OfASlope_ChangesEvenlyWithTheTemperature) {
    EXPECT_NEAR(indexOf({{"index.inside", 1.5},
                         {"temperature", 60.0},
                         {"temperature.measured", 25.0},
                         {"temperature.slope", -0.00045}}),
                1.48425, rounding);
}

/// What is left beside the release is how the molecules themselves change, an eighth of the whole.
TEST(Dielectric, OfWater_FallsWithItsDensityAsPublished) {
    constexpr double d = 587.5618;
    constexpr double cold = 998.207; // kg/m^3 at 20 degrees
    const double index = publishedIndexOfWater(d, 20.0, cold);
    for (const auto& [degrees, density] :
         {std::pair(30.0, 995.650), std::pair(60.0, 983.20), std::pair(90.0, 965.31)}) {
        const double warmer = degrees - 20.0;
        const double change = publishedIndexOfWater(d, degrees, density) - index;
        const double found = indexOf({{"index.inside", index},
                                      {"temperature", degrees},
                                      {"temperature.expansion", (cold / density - 1.0) / warmer}});
        EXPECT_NEAR(found - index, change, std::abs(change) / 8.0) << degrees;
    }
}

TEST(Dielectric, AtAnyTemperature_HasAnIndexInItsRange) {
    for (const double index : {0.01, 1.0, 1.5, 100.0}) {
        for (const double temperature : {-273.15, 0.0, 5000.0}) {
            for (const double change : {-0.01, 1e-6, 0.01}) {
                const Subject term("fresnel", "dielectric",
                                   {{"index.inside", index},
                                    {"temperature", temperature},
                                    {"temperature.expansion", change},
                                    {"temperature.slope", -change}});
                const double r = term.reflectance(0.5);
                EXPECT_TRUE(r >= 0.0 && r <= 1.0) << index << ' ' << temperature << ' ' << change;
            }
        }
    }
}

TEST(DispersiveFresnel, ByCauchysConstants_FollowsThePowersOfTheWavelength) {
    const Values values{{"formula", std::string("cauchy")},
                        {"cauchy", glm::dvec3(1.5, 0.004, 0.0002)},
                        {"temperature", 20.0},
                        {"temperature.measured", 20.0}};
    EXPECT_NEAR(indexByConstants(values, 500.0), 1.5 + 0.004 * 4.0 + 0.0002 * 16.0, rounding);
}

TEST(DispersiveFresnel, AtAPoleOrWithANegativeSquare_ReflectsAShareOfTheLight) {
    for (const double b : {-100.0, 1.0, 100.0}) {
        for (const double wavelength : {100.0, 550.0, 1e6}) {
            const double square = wavelength * wavelength * 1e-6;
            const double pole = std::min(square, 10000.0);
            const Values values{{"sellmeier.b", glm::dvec3(b, b, -b)},
                                {"sellmeier.c", glm::dvec3(pole)},
                                {"wavelength", glm::dvec3(wavelength)}};
            for (const double c : {0.0, 0.5, 1.0}) {
                const double r = Subject("fresnel", "dispersive", values).reflectance(c);
                EXPECT_TRUE(r >= 0.0 && r <= 1.0) << b << ' ' << wavelength << ' ' << c << ' ' << r;
            }
        }
    }
}

TEST(DielectricFresnel, EqualIndices_ReflectNothingAtAnyAngle) {
    for (const double c : {0.0, 1e-8, 0.3, 1.0}) {
        EXPECT_EQ(dielectric(1.5, 1.5).reflectance(c), 0.0);
    }
}

TEST(DielectricFresnel, NearlyEqualIndices_KeepTheirDigits) {
    // R(0) = ((n - 1) / (n + 1))^2 for n = 1 + 1e-6, a difference that a rounded g would lose.
    const double index = 1.0 + 1e-6;
    const double exact = std::pow((index - 1.0) / (index + 1.0), 2.0);
    EXPECT_NEAR(dielectric(1.0, index).reflectance(1.0) / exact, 1.0, 1e-9);
}

TEST(DielectricFresnel, SeenFromBothSides_IsTheSameAlongOneRay) {
    for (const double c : {0.05, 0.3, 0.7, 1.0}) {
        const double refracted = std::sqrt(1.0 - (1.0 - c * c) / (1.5 * 1.5));
        EXPECT_NEAR(dielectric(1.0, 1.5).reflectance(c),
                    dielectric(1.5, 1.0).reflectance(refracted), rounding);
    }
}

TEST(DielectricFresnel, PolarisedAlongAtBrewstersAngle_IsDark) {
    // tan(theta_B) = inside / outside; what is left is the square of a rounded difference.
    for (const auto& [outside, inside] :
         {std::pair(1.0, 1.333), std::pair(1.0, 1.5), std::pair(1.0, 2.417), std::pair(1.5, 1.0),
          std::pair(1.333, 1.5)}) {
        Values values{{"index.outside", outside}, {"index.inside", inside}};
        const double c = outside / std::hypot(outside, inside);
        values["polarisation"] = std::string("p");
        EXPECT_LT(Subject("fresnel", "dielectric", values).reflectance(c), 1e-30)
            << outside << ' ' << inside;
        // Rs = ((eta^2 - 1) / (eta^2 + 1))^2 there.
        const double eta2 = inside * inside / (outside * outside);
        values["polarisation"] = std::string("s");
        EXPECT_NEAR(Subject("fresnel", "dielectric", values).reflectance(c),
                    std::pow((eta2 - 1.0) / (eta2 + 1.0), 2.0), rounding)
            << outside << ' ' << inside;
    }
}

/// From index to index, also where both parts vanish.
TEST(DielectricRatio, IsThatOfBothPolarisations) {
    for (const double eta : {1.0, 1.0 + 1e-9, 1.001, 1.333, 2.417, 50.0, 1e4}) {
        for (const double degrees : {0.0, 1e-3, 20.0, 45.0, 56.3, 80.0, 89.999, 90.0}) {
            const double c = degrees == 90.0 ? 0.0 : std::cos(glm::radians(degrees));
            const double versine = 2.0 * std::pow(std::sin(glm::radians(0.5 * degrees)), 2.0);
            const double ratio = call("dielectricRatio", {c, versine, eta})[0];
            const double limit = std::pow(std::cos(glm::radians(2.0 * degrees)), 2.0);
            const auto parts = call("dielectricReflectances", {c, versine, 1.0, eta});
            EXPECT_NEAR(ratio, eta == 1.0 ? limit : parts[1] / parts[0], 1e-12)
                << eta << ' ' << degrees;
        }
    }
}

TEST(ConductorFresnel, WithoutAbsorption_IsTheDielectric) {
    for (const double eta : {0.05, 1.0 + 1e-6, 1.5, 100.0}) {
        for (const double c : {0.0, 1e-6, 0.1, 0.5, 0.9, 1.0}) {
            EXPECT_NEAR(conductor(eta, 0.0).reflectance(c), dielectric(1.0, eta).reflectance(c),
                        rounding)
                << eta << ' ' << c;
        }
    }
}

TEST(ConductorFresnel, OfTheIndexOutside_IsGivenByTheRatios) {
    for (const double c : {0.1, 0.5, 1.0}) {
        EXPECT_NEAR(conductor(0.3, 3.0, 1.5).reflectance(c), conductor(0.2, 2.0).reflectance(c),
                    rounding);
    }
}

TEST(ConductorFresnel, NoIndexButAbsorption_ReflectsEverything) {
    for (const double c : {0.0, 0.5, 1.0}) {
        EXPECT_EQ(conductor(0.0, 3.0).reflectance(c), 1.0);
    }
}

TEST(ConductorFresnel, StrongAbsorption_KeepsWhatIsLost) {
    // 1 - R(0) = 4 eta / ((eta + 1)^2 + k^2), which is 4e-4 here.
    const double lost = 4.0 / (4.0 + 1e4);
    EXPECT_NEAR((1.0 - conductor(1.0, 100.0).reflectance(1.0)) / lost, 1.0, 1e-11);
}

/// How far the form for a high index is from the exact one over all angles: below and above.
std::pair<double, double> highIndexErrors(const Values& metal, double outside) {
    Values values = metal;
    values["index.outside"] = outside;
    const Subject exact("fresnel", "conductor", values);
    Subject near = exact;
    near.parameters = packed(*near.block, values, {{"reflectance", "high-index"}});
    std::pair<double, double> errors{0.0, 0.0};
    for (int i = 1; i <= 2000; ++i) {
        const auto a = near.code->fresnel(i / 2000.0, 1.0 - i / 2000.0, near.parameters);
        const auto b = exact.code->fresnel(i / 2000.0, 1.0 - i / 2000.0, exact.parameters);
        for (const double error : {a.x - b.x, a.y - b.y, a.z - b.z}) {
            errors = {std::min(errors.first, error), std::max(errors.second, error)};
        }
    }
    return errors;
}

TEST(ConductorFresnel, HighIndex_IsAsFarOffAsItsLabelSays) {
    double inAir = 0.0;
    double underWater = 0.0;
    double underLacquer = 0.0;
    const Parameter& metals = *catalog().find("fresnel", "conductor")->parameter("metal");
    for (const EnumValue& metal : metals.values) {
        const auto [below, above] = highIndexErrors(metal.fills, 1.0);
        EXPECT_GE(below, -1e-9) << metal.id;
        inAir = std::max(inAir, above);
        underWater = std::min(underWater, highIndexErrors(metal.fills, 1.333).first);
        underLacquer = std::min(underLacquer, highIndexErrors(metal.fills, 1.5).first);
    }
    EXPECT_NEAR(inAir, 0.0071, 5e-5);
    EXPECT_NEAR(underWater, -0.014, 5e-4);
    EXPECT_NEAR(underLacquer, -0.027, 1e-3);
}

TEST(ConductorFresnel, HardIndices_StayBetweenZeroAndOne) {
    for (const double eta : {0.0, 1e-6, 0.05, 1.0, 1.0 + 1e-6, 1.5, 100.0}) {
        for (const double k : {0.0, 1e-6, 1e-3, 1.0, 10.0, 100.0}) {
            for (const double c : {0.0, 1e-8, 1e-4, 0.5, 1.0 - 1e-8, 1.0}) {
                const double R = conductor(eta, k).reflectance(c);
                EXPECT_TRUE(R >= 0.0 && R <= 1.0) << eta << ' ' << k << ' ' << c << ": " << R;
            }
        }
    }
}

Subject film(double thickness, double index, double eta, double k = 0.0) {
    return {"fresnel",
            "thin-film",
            {{"film.thickness", thickness},
             {"film.index", index},
             {"eta", glm::dvec3(eta)},
             {"k", glm::dvec3(k)},
             {"wavelength", glm::dvec3(550.0)}}};
}

TEST(ThinFilm, QuarterOfAWave_LeavesThirteenThousandthsOfGlassFourHundredths) {
    // R = ((n0 n2 - n1^2) / (n0 n2 + n1^2))^2: magnesium fluoride on crown glass.
    const double n2 = 1.52;
    const double n12 = 1.38 * 1.38;
    const double coated = film(550.0 / (4.0 * 1.38), 1.38, n2).reflectance(1.0);
    EXPECT_NEAR(coated, std::pow((n2 - n12) / (n2 + n12), 2.0), rounding);
    EXPECT_NEAR(coated, 0.013, 0.0005);
    EXPECT_NEAR(film(0.0, 1.38, n2).reflectance(1.0), 0.0426, 0.0001);
}

TEST(ThinFilm, WithoutThickness_IsTheBareMetalOrGlass) {
    for (const double c : {0.0, 1e-6, 0.1, 0.5, 0.9, 1.0}) {
        EXPECT_NEAR(film(0.0, 2.5, 2.9, 3.1).reflectance(c), conductor(2.9, 3.1).reflectance(c),
                    rounding);
        EXPECT_NEAR(film(0.0, 1.38, 1.5).reflectance(c), dielectric(1.0, 1.5).reflectance(c),
                    rounding);
    }
}

TEST(ThinFilm, HalfAWave_IsAsIfThereWereNone) {
    EXPECT_NEAR(film(550.0 / (2.0 * 1.38), 1.38, 1.52).reflectance(1.0),
                dielectric(1.0, 1.52).reflectance(1.0), rounding);
}

using Complex = std::complex<double>;

/// Returns |r|^2 of a film for light that swings across (s) or along the plane of incidence (p), by
/// the characteristic matrix with complex numbers; `delta` is 2 pi over the wavelength times the
/// thickness.
double filmShare(double c, double n0, double n1, Complex n2, double delta, bool isAcross) {
    const double across2 = n0 * n0 * (1.0 - c * c);
    const Complex u0 = n0 * c;
    const Complex u1 = std::sqrt(Complex(n1 * n1 - across2));
    const Complex u2 = std::sqrt(n2 * n2 - across2);
    const auto admittance = [isAcross](Complex n, Complex u) { return isAcross ? u : n * n / u; };
    const Complex y0 = admittance(n0, u0);
    const Complex y1 = admittance(n1, u1);
    const Complex y2 = admittance(n2, u2);
    const Complex i(0.0, 1.0);
    const Complex phase = delta * u1;
    const Complex b = std::cos(phase) - i * std::sin(phase) / y1 * y2;
    const Complex d = std::cos(phase) * y2 - i * y1 * std::sin(phase);
    return std::norm((y0 * b - d) / (y0 * b + d));
}

/// From glass an air gap lets less and less through: the film's u1 is then imaginary.
TEST(ThinFilm, AcrossAndAlongThePlane_AreThoseOfTheMatrix) {
    for (const double outside : {1.0, 1.5}) {
        for (const double index : {1.0001, 1.38, 2.5}) {
            for (const Complex below : {Complex(1.52), Complex(2.9, 3.1), Complex(0.2, 4.0)}) {
                for (const double thickness : {0.0, 100.0, 700.0}) {
                    const Subject made("fresnel", "thin-film",
                                       {{"film.thickness", thickness},
                                        {"film.index", index},
                                        {"eta", glm::dvec3(below.real())},
                                        {"k", glm::dvec3(below.imag())},
                                        {"index.outside", outside},
                                        {"wavelength", glm::dvec3(550.0)}});
                    for (const double c : {0.05, 0.3, 0.6, 0.9, 1.0}) {
                        const std::array<double, 2> incidence{c, 1.0 - c};
                        const double s = made.code->call<3>(reference::acrossSuffix, incidence,
                                                            made.parameters)[0];
                        const double p = 2.0 * made.reflectance(c) - s;
                        const double delta = 2.0 * std::numbers::pi * thickness / 550.0;
                        EXPECT_NEAR(s, filmShare(c, outside, index, below, delta, true), 1e-9)
                            << outside << ' ' << index << ' ' << below << ' ' << thickness << ' '
                            << c;
                        EXPECT_NEAR(p, filmShare(c, outside, index, below, delta, false), 1e-9)
                            << outside << ' ' << index << ' ' << below << ' ' << thickness << ' '
                            << c;
                    }
                }
            }
        }
    }
}

TEST(ThinFilm, AcrossThePlane_IsAShareInHardCases) {
    for (const double outside : {0.01, 1.0, 100.0}) {
        for (const double index : {0.1, 1.0, 10.0}) {
            for (const double eta : {0.0, 1e-6, 1.0, 100.0}) {
                for (const double k : {0.0, 100.0}) {
                    const Subject made("fresnel", "thin-film",
                                       {{"film.thickness", 10000.0},
                                        {"film.index", index},
                                        {"eta", glm::dvec3(eta)},
                                        {"k", glm::dvec3(k)},
                                        {"index.outside", outside},
                                        {"wavelength", glm::dvec3(100.0)}});
                    for (const double c : {0.0, 1e-8, 0.5, 1.0}) {
                        const std::array<double, 2> incidence{c, 1.0 - c};
                        const double s = made.code->call<3>(reference::acrossSuffix, incidence,
                                                            made.parameters)[0];
                        EXPECT_TRUE(s >= 0.0 && s <= 1.0)
                            << outside << ' ' << index << ' ' << eta << ' ' << k << ' ' << c;
                    }
                }
            }
        }
    }
}

TEST(BlinnF0Fresnel, FullReflectance_ReflectsEverythingAtEveryAngle) {
    const Subject fresnel("fresnel", "blinn-f0", {{"f0", glm::dvec3(1.0)}});
    for (const double c : {0.0, 1e-8, 0.5, 1.0}) {
        EXPECT_EQ(fresnel.reflectance(c), 1.0);
    }
}

TEST(BlinnF0Fresnel, FacingTheSurface_IsItsParameter) {
    for (const double F0 : {0.0, 1e-12, 0.04, 0.5, 1.0 - 1e-9}) {
        const Subject fresnel("fresnel", "blinn-f0", {{"f0", glm::dvec3(F0)}});
        EXPECT_NEAR(fresnel.reflectance(1.0), F0, 1e-15);
    }
}

TEST(EmpiricalFresnel, PowerZero_IsOneEverywhereAtScaleOne) {
    const Subject fresnel("fresnel", "empirical", {{"power", 0.0}});
    EXPECT_EQ(fresnel.reflectance(1.0), 1.0);
    EXPECT_EQ(fresnel.reflectance(0.0), 1.0);
}

TEST(ConstantFresnel, EveryAngle_GivesItsParameter) {
    const Subject fresnel("fresnel", "constant", {{"f0", glm::dvec3(0.3)}});
    EXPECT_EQ(fresnel.reflectance(0.0), 0.3);
    EXPECT_EQ(fresnel.reflectance(1.0), 0.3);
}

} // namespace
} // namespace patina::physics::fresnel_values_test
