// SPDX-License-Identifier: GPL-3.0-or-later
// How far the levels that read a table are from the exact ones: in double precision, so that the
// error is that of the means between entries alone.
#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "physics_cases.h"

namespace patina::physics::accuracy_tables_test {
namespace {

constexpr int tableSteps = 4000;

double largest(const std::function<double(double)>& difference) {
    double worst = 0.0;
    for (int i = 0; i <= tableSteps; ++i) {
        worst = std::max(worst, std::abs(difference(static_cast<double>(i) / tableSteps)));
    }
    return worst;
}

/// The largest error of the product of the grazing terms. The viewer stands at 45 degrees, so that
/// the highlight does not fade where the light grazes: without smoothness it is k times the product
/// times (r.v)^3.
double grazingError(const char* level, double kf = 1.12, double ks = 1.01) {
    const Values values{{"diffuse.color", black},
                        {"specular.color", white},
                        {"smoothness", 0.0},
                        {"metalness", 0.0},
                        {"transparency", 0.0},
                        {"k", 0.1},
                        {"kf", kf},
                        {"ks", ks}};
    const Subject exact("models", "strauss", values);
    const Subject cheap("models", "strauss", values, {{"terms", level}});
    const glm::dvec3 v = direction(45.0, 180.0);
    return largest([&](double u) {
        const double c = std::max(u * u, 1e-6); // more of them where the light grazes
        const glm::dvec3 l{std::sqrt((1.0 - c) * (1.0 + c)), 0.0, c};
        const double lobe = std::pow(glm::dot(glm::dvec3(-l.x, 0.0, l.z), v), 3.0);
        const auto at = geometry(l, v);
        return (cheap.shade(at).x - exact.shade(at).x) / (0.1 * lobe);
    });
}

void expectUpTo(double found, double stated) {
    EXPECT_LE(found, stated);
    EXPECT_GT(found, 0.9 * stated) << "it states too much";
}

TEST(StraussTable, WithItsWarpedAxis_IsClose) {
    expectUpTo(grazingError("table"), 1.4e-4);
}

TEST(StraussTable, WithAnEvenAxis_ErrsByASixteenth) {
    expectUpTo(grazingError("even-table"), 0.06);
    expectUpTo(grazingError("even-table", 10.0, 1.001), 0.51);
}

TEST(StraussTable, OfOtherConstants_StaysWithinWhatIsStated) {
    double worst = 0.0;
    for (const double kf : {1.001, 1.12, 2.0, 10.0}) {
        for (const double ks : {1.001, 1.01, 2.0, 10.0}) {
            worst = std::max(worst, grazingError("table", kf, ks));
        }
    }
    expectUpTo(worst, 0.062);
}

/// The largest error of the conductor's table, among all cosines.
double metalTableError(double eta, double k) {
    const Values values{{"eta", glm::dvec3(eta)}, {"k", glm::dvec3(k)}};
    const Subject exact("fresnel", "conductor", values);
    const Subject cheap("fresnel", "conductor", values, {{"reflectance", "table"}});
    return largest([&](double c) { return cheap.reflectance(c) - exact.reflectance(c); });
}

TEST(MetalTable, OfOtherMetals_IsWithinWhatIsStated) {
    expectUpTo(metalTableError(20.0, 20.0), 6e-3);
    double worst = 0.0;
    for (double eta = 0.08; eta < 1.0; eta += 0.002) {
        worst = std::max(worst, metalTableError(eta, 1e-5));
    }
    EXPECT_LE(worst, 0.51);
    EXPECT_GT(worst, 0.4) << "it states too much";
}

TEST(WaveTable, AtAnyRoughness_IsCloseToTheSeries) {
    const Subject mirror("fresnel", "constant", {{"f0", white}});
    for (const double sigma : {0.001, 0.05, 0.1, 0.2, 0.5, 2.0, 10.0}) {
        for (const double tau : {0.5, 2.0, 20.0}) {
            const Values values{
                {"diffuse.color", black}, {"sigma0", sigma}, {"tau", tau}, {"light.radius", 0.0}};
            const Subject exact("models", "he-torrance", values);
            const Subject cheap("models", "he-torrance", values, {{"series", "table"}});
            double peak = 0.0;
            double error = 0.0;
            for (double angle = 0.0; angle < 85.0; angle += 1.0) {
                const auto at = geometry(direction(30.0, 0.0), direction(angle, 180.0));
                const double right = exact.shade(at, mirror.filler()).y;
                peak = std::max(peak, right);
                error = std::max(error, std::abs(cheap.shade(at, mirror.filler()).y - right));
            }
            EXPECT_LE(error, 3.5e-4 * peak) << sigma << ' ' << tau;
        }
    }
}

} // namespace
} // namespace patina::physics::accuracy_tables_test
