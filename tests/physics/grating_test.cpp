// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "catalog/wavelengths.h"
#include "physics_cases.h"

namespace patina::physics::grating_test {
namespace {

constexpr double grooves = 1600.0;

/// Returns what the channels see of a wavelength, as the shader has it in doubles: the program's
/// wavelengths are floats.
glm::dvec3 seenOf(double wavelength, double uneven) {
    const auto srgb = call("srgbWavelengths", {});
    const auto seen =
        call("channelsSee", {wavelength, uneven, srgb[0] / srgbWavelengths.r,
                             srgb[1] / srgbWavelengths.g, srgb[2] / srgbWavelengths.b});
    return {seen[0], seen[1], seen[2]};
}

/// Returns a grating of even grooves along t without a mirror image.
Subject rainbows(int orders, double distance = grooves, double irregularity = 0.0) {
    return Subject("models", "grating",
                   {{"specular.color", glm::dvec3(1.0)},
                    {"groove.distance", distance},
                    {"irregularity", irregularity},
                    {"mirror", 0.0},
                    {"orders", orders},
                    {"roughness", 0.05}});
}

/// Returns the direction whose sines along and across the grooves are given.
glm::dvec3 upwards(double along, double across) {
    return {along, across, std::sqrt(std::max(1.0 - along * along - across * across, 0.0))};
}

TEST(SpectrumOfChannels, EachHasAnAreaOfOneAndNoneIsNegative_HoweverUneven) {
    for (const double uneven : {0.0, 0.03, 0.3, 1.0}) {
        glm::dvec3 area(0.0);
        for (double wavelength = 0.0; wavelength < 8000.0; wavelength += 0.25) {
            const glm::dvec3 seen = seenOf(wavelength, uneven);
            EXPECT_GE(std::min({seen.r, seen.g, seen.b}), 0.0);
            area += 0.25 * seen;
        }
        // What the bells would have below 0 nm is missing.
        const double missing = uneven < 0.1 ? 1e-6 : 1e-3;
        EXPECT_NEAR(area.r, 1.0, missing) << uneven;
        EXPECT_NEAR(area.g, 1.0, missing) << uneven;
        EXPECT_NEAR(area.b, 1.0, missing) << uneven;
    }
}

/// Returns linear sRGB of a pure wavelength by the paper's fit to the CIE's observer of 1931, in
/// which each function is a sum of bells; what is negative is 0.
glm::dvec3 channelsOfThePaper(double wavelength) {
    const auto bell = [wavelength](double middle, double below, double above) {
        const double t = (wavelength - middle) / (wavelength < middle ? below : above);
        return std::exp(-0.5 * t * t);
    };
    const glm::dvec3 xyz(1.056 * bell(599.8, 37.9, 31.0) + 0.362 * bell(442.0, 16.0, 26.7) -
                             0.065 * bell(501.1, 20.4, 26.2),
                         0.821 * bell(568.8, 46.9, 40.5) + 0.286 * bell(530.9, 16.3, 31.1),
                         1.217 * bell(437.0, 11.8, 36.0) + 0.681 * bell(459.0, 26.0, 13.8));
    return glm::max(glm::dvec3(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z,
                               -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                               0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z),
                    glm::dvec3(0.0));
}

TEST(SpectrumOfChannels, EachIsWithinATenthOfItsPeakOfTheObserver) {
    constexpr double step = 0.5;
    glm::dvec3 area(0.0);
    for (double wavelength = 360.0; wavelength < 810.0; wavelength += step) {
        area += step * channelsOfThePaper(wavelength);
    }
    glm::dvec3 farthest(0.0);
    glm::dvec3 peak(0.0);
    for (double wavelength = 360.0; wavelength < 810.0; wavelength += step) {
        const glm::dvec3 seen = seenOf(wavelength, 0.0);
        peak = glm::max(peak, seen);
        farthest = glm::max(farthest, glm::abs(seen - channelsOfThePaper(wavelength) / area));
    }
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_LT(farthest[channel], 0.1 * peak[channel]) << channel;
    }
    EXPECT_GT(farthest.r, 0.09 * peak.r) << "what is stated could be less";
}

TEST(Grating, Order_SendsTheWavelengthOfTheGratingEquation) {
    const Subject model = rainbows(1);
    for (const double lightDegrees : {0.0, 20.0, 60.0}) {
        const double sinA = std::sin(lightDegrees * std::numbers::pi / 180.0);
        for (const double wavelength : {450.0, 541.0, 602.5}) {
            // d (sin a + sin b) = lambda, on the other side of the mirror direction than -lambda.
            const double sinB = wavelength / grooves - sinA;
            const auto g = geometry(upwards(0.0, sinA), upwards(0.0, sinB));
            const glm::dvec3 light = model.shade(g);
            const glm::dvec3 seen = seenOf(wavelength, 0.0);
            const double largest = std::max({seen.r, seen.g, seen.b});
            const double scale = std::max({light.r, light.g, light.b}) / largest;
            EXPECT_NEAR(glm::distance(light / scale, seen), 0.0, 1e-12 * largest) << wavelength;
        }
    }
}

/// A channel is brightest where the wavelength that stands for it would be, moved as much as that.
TEST(Grating, OfOtherWavelengths_HasItsChannelsThere) {
    constexpr glm::dvec3 standing(650.0, 549.1f, 420.0);
    const auto brightest = [](const glm::dvec3& wavelengths, int channel) {
        const Subject model("models", "grating",
                            {{"specular.color", glm::dvec3(1.0)},
                             {"groove.distance", grooves},
                             {"irregularity", 0.0},
                             {"mirror", 0.0},
                             {"orders", 1},
                             {"wavelength", wavelengths}});
        double found = 0.0;
        double value = 0.0;
        for (double wavelength = 380.0; wavelength < 720.0; wavelength += 0.1) {
            const double seen = model.shade(
                geometry(upwards(0.0, 0.0), upwards(0.0, wavelength / grooves)))[channel];
            found = seen > value ? wavelength : found;
            value = std::max(value, seen);
        }
        return found;
    };
    for (int channel = 0; channel < 3; ++channel) {
        const double moved = standing[channel] / srgbWavelengths[channel];
        EXPECT_NEAR(brightest(standing, channel), moved * brightest({}, channel), 1.0) << channel;
    }
    constexpr glm::dvec3 fitted(602.5, 541.0, 445.2);
    for (int channel = 0; channel < 3; ++channel) { // the shader's sRGB is the program's
        EXPECT_NEAR(brightest({}, channel), fitted[channel], 0.06) << channel;
    }
}

TEST(Grating, SecondOrder_SendsHalfTheWavelengthWhereTheFirstSendsTheWhole) {
    // Where the first order is infrared, 1082 nm, the second is green.
    const auto g = geometry(upwards(0.0, 0.0), upwards(0.0, 2.0 * 541.0 / grooves));
    EXPECT_LT(rainbows(1).shade(g).g, 1e-12);
    const glm::dvec3 second = rainbows(2).shade(g);
    EXPECT_GT(second.g, 10.0 * second.r);
    EXPECT_GT(second.g, 10.0 * second.b);
}

TEST(Grating, OfUnevenGrooves_SendsTheMeanOfEvenOnesWhoseNumberPerLengthVaries) {
    constexpr double irregularity = 0.03;
    double largest = 0.0;
    double farthest = 0.0;
    for (double sine = 0.2; sine < 1.0; sine += 0.004) {
        const auto g = geometry(upwards(0.0, 0.0), upwards(0.0, sine));
        glm::dvec3 mean(0.0);
        double weights = 0.0;
        for (double deviation = -4.0; deviation <= 4.0; deviation += 0.1) {
            const double weight = std::exp(-0.5 * deviation * deviation);
            const double distance = grooves / (1.0 + irregularity * deviation);
            mean += weight * rainbows(2, distance).shade(g);
            weights += weight;
        }
        mean /= weights;
        const glm::dvec3 shown = rainbows(2, grooves, irregularity).shade(g);
        largest = std::max({largest, mean.r, mean.g, mean.b});
        const glm::dvec3 apart = glm::abs(shown - mean);
        farthest = std::max({farthest, apart.r, apart.g, apart.b});
    }
    EXPECT_LT(farthest, 0.035 * largest);
}

/// Returns the share of light from straight above that leaves, by a grid in the plane of the
/// directions' sines, where a solid angle times its cosine is an area.
glm::dvec3 reflectedBy(const Subject& model) {
    constexpr int side = 800;
    const glm::dvec3 l(0.0, 0.0, 1.0);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const double x = 2.0 * (i + 0.5) / side - 1.0;
            const double y = 2.0 * (j + 0.5) / side - 1.0;
            if (x * x + y * y < 1.0 && std::abs(x) < 0.6) {
                sum += model.shade(geometry(l, upwards(x, y)));
            }
        }
    }
    return sum * (4.0 / (side * side)) / std::numbers::pi;
}

TEST(Grating, WithRoomForAllOrders_GivesBackAllLightAsWhite) {
    for (const double irregularity : {0.0, 0.1}) {
        const Subject model("models", "grating",
                            {{"specular.color", glm::dvec3(1.0)},
                             {"groove.distance", 4000.0},
                             {"irregularity", irregularity},
                             {"mirror", 0.3},
                             {"orders", 3},
                             {"roughness", 0.05}});
        const glm::dvec3 all = reflectedBy(model);
        EXPECT_NEAR(all.r, 1.0, 1e-3) << irregularity;
        EXPECT_NEAR(all.g, 1.0, 1e-3) << irregularity;
        EXPECT_NEAR(all.b, 1.0, 1e-3) << irregularity;
    }
}

TEST(Grating, OrdersWithoutRoom_AreLost) {
    const glm::dvec3 all = reflectedBy(rainbows(8));
    EXPECT_LT(std::max({all.r, all.g, all.b}), 1.0);
    EXPECT_GT(std::min({all.r, all.g, all.b}), 0.3);
}

} // namespace
} // namespace patina::physics::grating_test
