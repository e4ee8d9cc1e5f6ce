// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "lobe_cases.h"
#include "measure/lobe/lobe_factor.h"
#include "measure/lobe/lobe_lines.h"

namespace patina::physics::lobe_factor_test {
namespace {

constexpr double pi = std::numbers::pi;

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
    for (const char* ggx : {"anisotropic-ggx", "metallic-roughness"}) {
        EXPECT_NEAR(integralOver(factorOf(materialOf(ggx), LobeTerm::Distribution), true), 1.0,
                    2e-3)
            << ggx;
    }
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

} // namespace
} // namespace patina::physics::lobe_factor_test
