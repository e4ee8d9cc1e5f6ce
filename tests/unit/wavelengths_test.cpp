// SPDX-License-Identifier: GPL-3.0-or-later
// Which wavelengths stand for red, green and blue.
#include "catalog/wavelengths.h"

#include <array>
#include <cmath>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "catalog/block_kind.h"

namespace patina::wavelengths_test {
namespace {

Parameter wavelengthsIn(const char* unit) {
    Parameter parameter;
    parameter.type = ParameterType::Vec3;
    parameter.role = roles::wavelengths;
    parameter.unit = unit;
    return parameter;
}

std::array<double, 3> taken(const Parameter& parameter, std::array<double, 3> numbers) {
    takeWavelengths(parameter, {700.0, 500.0, 400.0}, numbers.data());
    return numbers;
}

TEST(Wavelengths, OfAMaterial_AreTheScenesWhereItNamesNone) {
    const std::array<double, 3> none{0.0, 0.0, 0.0};
    EXPECT_EQ(taken(wavelengthsIn("nm"), none), (std::array{700.0, 500.0, 400.0}));
    EXPECT_EQ(taken(wavelengthsIn("nm"), {650.0, 99.0, NAN}), (std::array{650.0, 500.0, 400.0}));
    const auto micrometres = taken(wavelengthsIn("µm"), {0.65, -1.0, 0.09});
    EXPECT_DOUBLE_EQ(micrometres[0], 0.65);
    EXPECT_DOUBLE_EQ(micrometres[1], 0.5);
    EXPECT_DOUBLE_EQ(micrometres[2], 0.4);
}

TEST(Wavelengths, ThatAreNone_StayAsTheyAre) {
    Parameter other = wavelengthsIn("nm");
    other.role.clear();
    EXPECT_EQ(taken(other, {0.0, 1.0, 2.0}), (std::array{0.0, 1.0, 2.0}));
}

TEST(Wavelengths, OfTheScene_MoveAllLightWithThem) {
    for (const double wavelength : {380.0, 464.3, 500.0, 549.1, 611.4, 730.0}) {
        EXPECT_NEAR(movedWavelength(wavelength, srgbWavelengths), wavelength, 1e-12);
    }
    const glm::dvec3 other(700.0, 500.0, 400.0);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(movedWavelength(srgbWavelengths[channel], other), other[channel], 1e-12);
    }
    EXPECT_NEAR(movedWavelength(srgbWavelengths.z - 50.0, other), 350.0, 1e-12);
    EXPECT_NEAR(movedWavelength(srgbWavelengths.x + 50.0, other), 750.0, 1e-12);
    for (const glm::dvec3& odd : {glm::dvec3(100.0), glm::dvec3(400.0, 500.0, 600.0),
                                  glm::dvec3(2000.0, 100.0, 2000.0)}) {
        for (double wavelength = 380.0; wavelength <= 730.0; wavelength += 10.0) {
            const double moved = movedWavelength(wavelength, odd);
            EXPECT_TRUE(moved >= 100.0 && moved <= 2500.0) << moved;
        }
    }
}

/// Is a pure colour of the CIE's observer of 1931 (CIE 15:2004, table T.5).
struct PureColor {
    double wavelength; ///< nm
    glm::dvec2 xy;
};

/// Tells on which side of the line from white through a primary a colour lies.
double beside(const glm::dvec2& primary, const glm::dvec2& xy) {
    const glm::dvec2 white(0.3127, 0.3290);
    const glm::dvec2 line = primary - white;
    const glm::dvec2 way = xy - white;
    return line.x * way.y - line.y * way.x;
}

TEST(Wavelengths, AtFirst_AreTheDominantOnesOfThePrimariesOfSrgb) {
    const std::array<glm::dvec2, 3> primaries{glm::dvec2(0.64, 0.33), glm::dvec2(0.30, 0.60),
                                              glm::dvec2(0.15, 0.06)};
    const std::array<std::array<PureColor, 2>, 3> around{
        {{{{610.0, {0.6658, 0.3340}}, {615.0, {0.6801, 0.3197}}}},
         {{{545.0, {0.2658, 0.7243}}, {550.0, {0.3016, 0.6923}}}},
         {{{460.0, {0.1440, 0.0297}}, {465.0, {0.1355, 0.0399}}}}}};
    for (std::size_t i = 0; i < 3; ++i) {
        const double below = beside(primaries[i], around[i][0].xy);
        const double above = beside(primaries[i], around[i][1].xy);
        ASSERT_LT(below * above, 0.0);
        const double found = around[i][0].wavelength + 5.0 * below / (below - above);
        EXPECT_NEAR(found, srgbWavelengths[static_cast<int>(i)], 0.2) << i;
    }
}

} // namespace
} // namespace patina::wavelengths_test
