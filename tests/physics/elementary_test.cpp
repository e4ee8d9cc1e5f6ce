// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>

#include "physics_cases.h"

namespace patina::physics::elementary_test {
namespace {

const reference::Function& polynomial(const std::string& name) {
    for (const reference::Function& function : reference::elementaryPolynomials()) {
        if (function.name == name) {
            return function;
        }
    }
    throw std::runtime_error("no polynomial " + name);
}

std::vector<double> approximation(const std::string& name, const std::vector<double>& arguments) {
    const reference::Function& function = polynomial(name);
    std::vector<double> results(function.results);
    function.call(arguments.data(), results.data());
    return results;
}

/// The largest relative error of every result over n arguments made from 0 .. 1.
double worstError(const std::string& name,
                  const std::function<std::vector<double>(double)>& arguments) {
    constexpr int n = 20000;
    double worst = 0.0;
    for (int i = 0; i <= n; ++i) {
        const std::vector<double> in = arguments(static_cast<double>(i) / n);
        const std::vector<double> near = approximation(name, in);
        const std::vector<double> exact = call(name, in);
        for (std::size_t k = 0; k < exact.size(); ++k) {
            const double size = std::max(std::abs(exact[k]), 1e-30);
            worst = std::max(worst, std::abs(near[k] - exact[k]) / size);
        }
    }
    return worst;
}

// The bounds are those stated beside each function in shaders/lib/elementary.glsl; in double
// precision only the polynomial's own error is left.

TEST(Elementary, AtanhOverZ_KeepsItsBound) {
    EXPECT_LT(worstError("atanhOverZ", [](double u) { return std::vector{u / 9.0}; }), 5e-9);
}

TEST(Elementary, Acos2_KeepsItsBound) {
    EXPECT_LT(worstError("acos2", [](double u) { return std::vector{2.0 * u}; }), 3e-7);
}

TEST(Elementary, AsinS_KeepsItsBound) {
    const auto arguments = [](double u) { return std::vector{(2.0 * u - 1.0) * std::sqrt(0.5)}; };
    EXPECT_LT(worstError("asinS", arguments), 2e-8);
}

TEST(Elementary, VersineOf_KeepsItsBound) {
    const auto arguments = [](double u) { return std::vector{u * std::numbers::pi}; };
    EXPECT_LT(worstError("versineOf", arguments), 4e-7);
}

TEST(Elementary, MinusLnCosBySin2_KeepsItsBound) {
    const auto squares = [](double u) { return std::vector{u, 1.0 - 0.999 * u}; };
    EXPECT_LT(worstError("minusLnCosBySin2", squares), 3e-7);
}

TEST(Elementary, Ierfc_KeepsItsBound) {
    for (double a = 0.0; a < 12.0; a += 1e-3) {
        const double exact = call("ierfc", {a})[0];
        EXPECT_NEAR(approximation("ierfc", {a})[0], exact, 4e-8 * (2.0 * a + exact)) << a;
    }
}

TEST(Elementary, GaussianShare_KeepsItsBound) {
    const auto width = [](double u) { return std::vector{1e-9 + 1.45 * u}; };
    EXPECT_LT(worstError("gaussianShare", width), 2e-7);
}

/// Half the integral of e^(-theta^2 / w) sin(2 theta) is that of sin(theta) cos(theta) e^(...).
TEST(Elementary, GaussianShare_MatchesTheTabulatedIntegral) {
    // Blinn's Gaussian of width 0.3 integrates to 0.26637406875084752 over the hemisphere.
    EXPECT_NEAR(std::numbers::pi * 0.09 * call("gaussianShare", {0.09})[0], 0.26637406875084752,
                1e-15);
}

TEST(Elementary, AngleOf_KeepsItsBound) {
    const auto angle = [](double u) { return 0.5 * std::numbers::pi * u; };
    const auto unit = [&](double u) { return std::vector{std::sin(angle(u)), std::cos(angle(u))}; };
    EXPECT_LT(worstError("angleOf", unit), 2e-8);
}

TEST(Elementary, AngXY_KeepsItsBound) {
    const auto arguments = [](double u) {
        const double angle = 0.5 * std::numbers::pi * u;
        return std::vector{std::cos(angle), std::pow(std::sin(angle), 2.0)};
    };
    EXPECT_LT(worstError("angXY", arguments), 2e-7);
}

TEST(Elementary, PowersOfCosines_KeepTheirBoundForEveryExponent) {
    for (const double e : {0.0, 0.5, 1.0, 25.0, 1000.0}) {
        const auto versine = [e](double u) { return std::vector{u, 1.0 - u, e}; };
        const auto squares = [e](double u) { return std::vector{u, 1.0 - u, e}; };
        // Where the result is no longer a float's, e L is at most 87.
        const double bound = 2e-6 + 2e-7 * std::min(e * 20.0, 87.0);
        EXPECT_LT(worstError("pow1m", versine), bound) << "exponent " << e;
        EXPECT_LT(worstError("powSC", squares), bound) << "exponent " << e;
    }
}

TEST(Elementary, AtanhExcess_KeepsItsBound) {
    EXPECT_LT(worstError("atanhExcess", [](double u) { return std::vector{u / 9.0}; }), 6e-6);
}

TEST(Elementary, ErfcOf_KeepsItsBound) {
    EXPECT_LT(worstError("erfcOf", [](double u) { return std::vector{8.0 * u}; }), 4e-8);
}

TEST(Elementary, MeanOfExp_KeepsItsBound) {
    const auto arguments = [](double u) { return std::vector{std::pow(10.0, 40.0 * u - 30.0)}; };
    EXPECT_LT(worstError("meanOfExp", arguments), 1e-7);
}

TEST(Elementary, LambertW_KeepsItsBound) {
    const auto arguments = [](double u) { return std::vector{std::pow(10.0, 60.0 * u - 30.0)}; };
    EXPECT_LT(worstError("lambertW", arguments), 2e-6);
}

TEST(Elementary, LambertW_SolvesItsEquation) {
    for (const double x : {1e-12, 1e-3, 0.5, 2.7, 2.8, 100.0, 1e15}) {
        const double w = call("lambertW", {x})[0];
        EXPECT_NEAR(w * std::exp(w) / x, 1.0, 1e-13 * (1.0 + w)) << x;
    }
}

TEST(Elementary, StirlingError_KeepsItsBound) {
    for (double m = 1.0; m < 1000.0; m += 1.0) {
        EXPECT_NEAR(approximation("stirlingError", {m})[0], call("stirlingError", {m})[0], 3e-8)
            << m;
    }
}

TEST(Elementary, PowNear1_KeepsItsBoundOnBothSides) {
    for (const double e : {0.0, 1.0, 25.0}) {
        const auto around = [](double u) { return 2.9 * u - 1.9; };
        const auto versine = [&](double u) { return std::vector{around(u), 1.0 - around(u), e}; };
        EXPECT_LT(worstError("powNear1", versine), 2e-6 + 2e-7 * e) << "exponent " << e;
    }
}

TEST(Elementary, PowersBelowTheHorizon_AreZeroEvenForExponentZero) {
    EXPECT_EQ(call("pow1m", {1.5, -0.5, 0.0})[0], 0.0);
    EXPECT_EQ(call("powSC", {1.0, 0.0, 0.0})[0], 0.0);
}

TEST(Elementary, EveryPolynomial_HasATwinOfTheSameShape) {
    for (const reference::Function& function : reference::elementaryPolynomials()) {
        const reference::Function* twin = reference::findFunction(function.name);
        ASSERT_NE(twin, nullptr);
        EXPECT_EQ(twin->signature, function.signature);
    }
}

} // namespace
} // namespace patina::physics::elementary_test
