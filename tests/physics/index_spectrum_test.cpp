// SPDX-License-Identifier: GPL-3.0-or-later
// Optical constants over the wavelength.
#include <gtest/gtest.h>

#include "catalog/wavelengths.h"
#include "lobe_cases.h"
#include "measure/lobe/fresnel_curve.h"
#include "measure/lobe/index_spectrum.h"

namespace patina::physics::index_spectrum_test {
namespace {

Material withTerm(const std::string& id, const Values& values = {}) {
    Material material = materialOf("cook-torrance");
    material.parts["fresnel"] = {id, 1, values, nlohmann::json::object()};
    return material;
}

IndexSpectrum spectrumOf(const Material& material) {
    auto spectrum = indexSpectrum(catalog(), material);
    EXPECT_TRUE(spectrum) << (spectrum ? "" : spectrum.error().text());
    return spectrum.value_or(IndexSpectrum());
}

double valueAtWavelength(const IndexSpectrum& spectrum, const std::vector<double>& values,
                         double nm) {
    const auto after = std::ranges::lower_bound(spectrum.wavelengths, nm);
    const auto right = static_cast<std::size_t>(after - spectrum.wavelengths.begin());
    const double from = spectrum.wavelengths[right - 1];
    const double share = (nm - from) / (spectrum.wavelengths[right] - from);
    return values[right - 1] + share * (values[right] - values[right - 1]);
}

/// Schott's data sheet of N-BK7, whose constants are the block's defaults, at the temperature of
/// the measurement.
TEST(IndexSpectrum, OfGlass_HasTheCataloguesIndices) {
    const IndexSpectrum spectrum = spectrumOf(withTerm("dispersive", {{"temperature", 22.0}}));
    constexpr double published[][2] = {
        {435.8343, 1.52668}, {486.1327, 1.52238}, {587.5618, 1.51680}, {656.2725, 1.51432}};
    for (const auto& [nm, index] : published) {
        EXPECT_NEAR(valueAtWavelength(spectrum, spectrum.index, nm), index, 6e-6) << nm;
    }
    EXPECT_FALSE(spectrum.isOfChannels);
    EXPECT_TRUE(spectrum.extinction.empty());
    EXPECT_EQ(spectrum.channels, srgbWavelengths);
    EXPECT_EQ(spectrum.wavelengths.front(), 380.0);
    EXPECT_EQ(spectrum.wavelengths.back(), 780.0);
}

TEST(IndexSpectrum, OfCauchysConstants_IsTheirSeries) {
    const IndexSpectrum spectrum =
        spectrumOf(withTerm("dispersive", {{"formula", std::string("cauchy")},
                                           {"cauchy", glm::dvec3(1.5046, 0.0042, 0.0)},
                                           {"temperature.slope", 0.0}}));
    for (std::size_t i = 0; i < spectrum.wavelengths.size(); ++i) {
        const double um = 1e-3 * spectrum.wavelengths[i];
        EXPECT_NEAR(spectrum.index[i], 1.5046 + 0.0042 / (um * um), 1e-12);
    }
}

TEST(IndexSpectrum, OfChannelsFarFromTheVisible_ReachesThem) {
    const IndexSpectrum spectrum =
        spectrumOf(withTerm("dispersive", {{"wavelength", glm::dvec3(1500.0, 550.0, 300.0)}}));
    EXPECT_EQ(spectrum.wavelengths.front(), 300.0);
    EXPECT_EQ(spectrum.wavelengths.back(), 1500.0);
}

TEST(IndexSpectrum, OfAMetal_IsKnownAtItsChannels) {
    const IndexSpectrum spectrum =
        spectrumOf(withTerm("conductor", {{"eta", glm::dvec3(0.156, 0.424, 1.383)},
                                          {"k", glm::dvec3(3.602, 2.472, 1.915)}}));
    EXPECT_TRUE(spectrum.isOfChannels);
    EXPECT_EQ(spectrum.wavelengths, (std::vector{450.0, 550.0, 650.0}));
    EXPECT_EQ(spectrum.index, (std::vector{1.383, 0.424, 0.156}));
    EXPECT_EQ(spectrum.extinction, (std::vector{1.915, 2.472, 3.602}));
    for (std::size_t i = 0; i < 3; ++i) {
        const double n = spectrum.index[i];
        const double k = spectrum.extinction[i];
        EXPECT_NEAR(spectrum.reflectance[i],
                    ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k), 1e-14);
    }
}

/// A quarter of a wavelength of magnesium fluoride on glass: ((n - n1^2) / (n + n1^2))^2 at that
/// wavelength (Born and Wolf, section 1.6.4), and more on both sides.
TEST(IndexSpectrum, OfAnAntiReflectiveCoating_IsDarkestAtItsWavelength) {
    const IndexSpectrum spectrum =
        spectrumOf(withTerm("thin-film", {{"film.thickness", 550.0 / 4.0 / 1.38},
                                          {"film.index", 1.38},
                                          {"eta", glm::dvec3(1.52)},
                                          {"k", glm::dvec3(0.0)}}));
    const auto darkest = std::ranges::min_element(spectrum.reflectance);
    const auto place = static_cast<std::size_t>(darkest - spectrum.reflectance.begin());
    EXPECT_EQ(spectrum.wavelengths[place], 550.0);
    EXPECT_NEAR(*darkest, std::pow((1.52 - 1.38 * 1.38) / (1.52 + 1.38 * 1.38), 2.0), 1e-12);
    EXPECT_GT(spectrum.reflectance.front(), 1.3 * *darkest);
}

/// The dispersion of a refraction is 20 over Abbe's number, (n_d - 1) / (n_F - n_C).
TEST(IndexSpectrum, OfADispersedBody_HasItsAbbeNumber) {
    Material material = withTerm("dielectric", {{"index.inside", 1.5}, {"index.outside", 1.0}});
    material.parts["refraction"] = {
        "solid-body", 1, {{"dispersion", 0.5}}, nlohmann::json::object()};
    const IndexSpectrum spectrum = spectrumOf(material);
    const auto at = [&](double nm) { return valueAtWavelength(spectrum, spectrum.index, nm); };
    EXPECT_NEAR(at(587.6), 1.5, 1e-6);
    EXPECT_NEAR((at(587.6) - 1.0) / (at(486.1) - at(656.3)), 40.0, 0.01);
}

TEST(IndexSpectrum, OfAReflectance_IsNotKnown) {
    EXPECT_FALSE(indexSpectrum(catalog(), withTerm("schlick")));
    EXPECT_FALSE(indexSpectrum(catalog(), materialOf("lambert")));
}

/// Glass by constants has Fresnel's curves of each channel, too: their mean is what it reflects.
TEST(FresnelCurve, OfGlassByConstants_HasBothPolarisations) {
    const auto curves = fresnelCurves(catalog(), withTerm("dispersive"));
    ASSERT_TRUE(curves && curves->media && curves->media->isClear());
    EXPECT_GT(curves->media->index.z, curves->media->index.x); // blue bends more
    for (const FresnelPoint& point : curves->term) {
        EXPECT_LT(worst(point.exact, reflectedAt(*curves->media, point.angle).mean()), 1e-14);
    }
}

} // namespace
} // namespace patina::physics::index_spectrum_test
