// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::he_torrance_test {
namespace {

constexpr double sigma0 = 0.2;
constexpr double tau = 1.5;
constexpr double wavelength = 0.5;

/// A reflectance of 1 at every angle.
reference::Filler everything() {
    static const Subject mirror("fresnel", "constant", {{"f0", white}});
    return mirror.filler();
}

Values measured(double height) {
    return {{"sigma0", height}, {"tau", tau}, {"wavelengths", glm::dvec3(wavelength)}};
}

glm::dvec3 vectorOf(const nlohmann::json& json) {
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

/// pi f cos(theta_l) with f = rho_dd of the table.
TEST(HeTorrance, DirectionalDiffusePart_MatchesItsTable) {
    const Subject model("models", "he-torrance", measured(sigma0));
    for (const auto& row : table("he_torrance.json")["rows"]) {
        const glm::dvec3 l = vectorOf(row["l"]);
        const double value = model.shade(geometry(l, vectorOf(row["v"])), everything()).x;
        const double rho = value / (std::numbers::pi * glm::normalize(l).z);
        EXPECT_NEAR(rho / row["rho_dd"].get<double>(), 1.0, 1e-10) << row["name"];
    }
}

TEST(HeTorrance, EffectiveRoughnessAndShadowing_MatchTheirTable) {
    for (const auto& row : table("he_torrance.json")["rows"]) {
        const double nl = glm::normalize(vectorOf(row["l"])).z;
        const double nv = glm::normalize(vectorOf(row["v"])).z;
        const double Kl = call("roughnessLoss", {nl, 1.0 - nl * nl, sigma0, tau})[0];
        const double Kv = call("roughnessLoss", {nv, 1.0 - nv * nv, sigma0, tau})[0];
        const double sigma = sigma0 * std::sqrt(call("effectiveRoughness2", {Kl, Kv})[0]);
        EXPECT_NEAR(sigma, row["sigma"].get<double>(), 1e-12) << row["name"];
        const double S = nl * call("waveShadowing", {nl, 1.0 - nl * nl, sigma0, tau})[0] * nv *
                         call("waveShadowing", {nv, 1.0 - nv * nv, sigma0, tau})[0];
        EXPECT_NEAR(S, row["S"].get<double>(), 1e-12) << row["name"];
    }
}

double plainSeries(double g, double x) {
    double sum = 0.0;
    for (int m = 1; m < 3000; ++m) {
        sum += std::exp((m - 1) * std::log(g) - g - x / m - std::lgamma(m + 1.0)) / m;
    }
    return sum;
}

double waveSeries(const std::vector<double>& arguments) {
    return std::ldexp(call("waveSeries", arguments)[0], -60);
}

TEST(WaveSeries, EveryRoughness_IsTheSumOfItsTerms) {
    for (const double g : {1e-6, 0.1, 1.0, 8.0, 31.0, 41.0, 60.0, 200.0, 1500.0}) {
        for (const double x : {0.0, 0.3, 5.0, 60.0}) {
            const double sum = waveSeries({g, x, 20.0, 8.0, 8.0});
            EXPECT_NEAR(sum / plainSeries(g, x), 1.0, 1e-10) << g << ' ' << x;
        }
    }
}

TEST(WaveSeries, FewerTerms_KeepTheirBounds) {
    for (const double g : {0.1, 1.0, 8.0, 60.0, 1500.0}) {
        for (const double x : {0.0, 5.0, 60.0}) {
            const double all = plainSeries(g, x);
            EXPECT_NEAR(waveSeries({g, x, 10.0, 4.5, 3.0}) / all, 1.0, 1e-5);
            EXPECT_NEAR(waveSeries({g, x, 6.0, 3.3, 1.0}) / all, 1.0, 1e-3);
        }
    }
}

/// A very rough surface mirrors geometrically: Cook and Torrance with Beckmann's facets of the
/// slope 2 sigma0 / tau, to 0.8 / g.
TEST(HeTorrance, VeryRoughSurface_IsBeckmanns) {
    const Values rough{{"sigma0", 10.0}, {"tau", 75.0}, {"wavelengths", glm::dvec3(0.1)}};
    const Subject model("models", "he-torrance", rough);
    const glm::dvec3 l = direction(30.0, 0.0);
    const glm::dvec3 v = direction(45.0, 120.0);
    const glm::dvec3 h = glm::normalize(l + v);
    const double alpha = 2.0 * 10.0 / 75.0;
    const double c2 = h.z * h.z;
    const double D =
        std::exp((c2 - 1.0) / (c2 * alpha * alpha)) / (std::numbers::pi * alpha * alpha * c2 * c2);
    const double S = l.z * call("waveShadowing", {l.z, 1.0 - l.z * l.z, 10.0, 75.0})[0] * v.z *
                     call("waveShadowing", {v.z, 1.0 - v.z * v.z, 10.0, 75.0})[0];
    const double facets = std::numbers::pi * D * S / (4.0 * v.z);
    EXPECT_NEAR(model.shade(geometry(l, v), everything()).x / facets, 1.0, 1e-4);
}

/// With s or p light alone the model is |F_s|^2 or |F_p|^2 times what it is with |F|^2 = 1.
TEST(HeTorrance, OfLightOfOnePolarisation_HasItsFresnelReflectance) {
    const Subject model("models", "he-torrance", measured(sigma0));
    const glm::dvec3 l = direction(50.0, 0.0);
    const glm::dvec3 v = direction(62.0, 170.0);
    const double c = std::sqrt(0.5 * (1.0 + glm::dot(l, v)));
    const double t = std::sqrt(1.0 - (1.0 - c * c) / 2.25);
    const double plain = model.shade(geometry(l, v), everything()).x;
    const auto with = [&](const char* polarisation) {
        const Subject glass("fresnel", "dielectric",
                            {{"index.outside", 1.0},
                             {"index.inside", 1.5},
                             {"polarisation", std::string(polarisation)}});
        return model.shade(geometry(l, v), glass.filler()).x / plain;
    };
    const double s = (c - 1.5 * t) / (c + 1.5 * t);
    const double p = (1.5 * c - t) / (1.5 * c + t);
    EXPECT_NEAR(with("s"), s * s, 1e-12);
    EXPECT_NEAR(with("p"), p * p, 1e-12);
    EXPECT_NEAR(with("unpolarised"), 0.5 * (s * s + p * p), 1e-12);
}

TEST(HeTorrance, PolishedSurface_ScattersNothing) {
    const Subject model("models", "he-torrance", measured(0.0));
    EXPECT_EQ(model.shade(geometry(direction(30, 0), direction(20, 90)), everything()).x, 0.0);
}

/// Without roughness the mirror image holds all that is reflected: the integral over viewers of
/// f (n.v) is 1 facing the surface.
TEST(HeTorrance, MirrorImage_HoldsAllOfAPolishedSurface) {
    Values values = measured(0.0);
    values["light.radius"] = 5.0;
    const Subject model("models", "he-torrance", values);
    double sum = 0.0;
    constexpr int rings = 4000;
    for (int i = 0; i < rings; ++i) {
        const double degrees = 6.0 * (i + 0.5) / rings;
        const double theta = degrees * std::numbers::pi / 180.0;
        const double value =
            model.shade(geometry({0, 0, 1}, direction(degrees, 40.0)), everything()).x;
        sum += value / std::numbers::pi * std::cos(theta) * 2.0 * std::numbers::pi *
               std::sin(theta) * 6.0 / rings * std::numbers::pi / 180.0;
    }
    EXPECT_NEAR(sum, 1.0, 2e-3); // cos of at most 5 degrees
}

} // namespace
} // namespace patina::physics::he_torrance_test
