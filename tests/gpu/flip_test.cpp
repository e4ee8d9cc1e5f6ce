// SPDX-License-Identifier: GPL-3.0-or-later
// FLIP against what its authors' program (github.com/NVlabs/flip, the Python of version 1.2, run in
// double precision) says about pictures that are made by code. That it uses rounded inverses of its
// matrices shows in the seventh digit.
#include "measure/error/flip.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace patina::flip_test {
namespace {

constexpr int side = 32;
constexpr double tolerance = 2e-6;

using Picture = std::vector<glm::dvec3>;

/// Two gradients and, in blue, stripes that are moved by `shift`.
Picture striped(int shift) {
    Picture made;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            made.emplace_back(x / 31.0, y / 31.0, (x * 7 + y * 3 + shift) % 32 / 31.0);
        }
    }
    return made;
}

Picture flat(const glm::dvec3& color) {
    return Picture(std::size_t(side * side), color);
}

std::vector<double> differences(const Picture& right, const Picture& shown) {
    return Flip({side, side}, right).differences(shown);
}

double mean(const std::vector<double>& map) {
    return std::accumulate(map.begin(), map.end(), 0.0) / double(map.size());
}

double inTheMiddle(const std::vector<double>& map) {
    return map[16 * side + 16];
}

TEST(Flip, SamePictures_DoNotDiffer) {
    EXPECT_EQ(mean(differences(striped(0), striped(0))), 0.0);
}

TEST(Flip, GreenAndBlue_DifferMost) {
    EXPECT_NEAR(mean(differences(flat({0.0, 1.0, 0.0}), flat({0.0, 0.0, 1.0}))), 1.0, tolerance);
}

TEST(Flip, BlackAndWhite_DifferAsTheAuthorsSay) {
    EXPECT_NEAR(mean(differences(flat(glm::dvec3(0.0)), flat(glm::dvec3(1.0)))), 0.967380,
                tolerance);
}

TEST(Flip, MovedStripes_DifferAsTheAuthorsSay) {
    const std::vector<double> map = differences(striped(0), striped(8));
    EXPECT_NEAR(mean(map), 0.147275, tolerance);
    EXPECT_NEAR(*std::max_element(map.begin(), map.end()), 0.595472, tolerance);
    EXPECT_NEAR(inTheMiddle(map), 0.116075, tolerance);
}

TEST(Flip, InvertedPatch_DiffersAsTheAuthorsSay) {
    Picture shown = striped(0);
    for (int y = 10; y < 20; ++y) {
        for (int x = 8; x < 24; ++x) {
            glm::dvec3& color = shown[std::size_t(y * side + x)];
            color = 1.0 - color;
        }
    }
    const std::vector<double> map = differences(striped(0), shown);
    EXPECT_NEAR(mean(map), 0.153416, tolerance);
    EXPECT_NEAR(*std::max_element(map.begin(), map.end()), 0.898863, tolerance);
    EXPECT_NEAR(inTheMiddle(map), 0.319621, tolerance);
}

TEST(Flip, LiftedPicture_DiffersAsTheAuthorsSay) {
    Picture shown = striped(0);
    for (glm::dvec3& color : shown) {
        color = glm::min(color + 0.02, glm::dvec3(1.0));
    }
    const std::vector<double> map = differences(striped(0), shown);
    EXPECT_NEAR(mean(map), 0.128960, tolerance);
    EXPECT_NEAR(inTheMiddle(map), 0.114778, tolerance);
}

} // namespace
} // namespace patina::flip_test
