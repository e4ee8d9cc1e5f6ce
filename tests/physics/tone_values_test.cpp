// SPDX-License-Identifier: GPL-3.0-or-later
// Tone curves against their published formulas, as their papers write them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/mat3x3.hpp>

#include "physics_cases.h"

namespace patina::physics::tone_values_test {
namespace {

glm::dvec3 shown(const std::string& id, const glm::dvec3& light, const Values& values = {}) {
    const Subject tone("tone", id, values);
    return tone.code->toned(light, tone.parameters);
}

const std::vector<glm::dvec3> lights{{0.0, 0.0, 0.0},    {0.001, 0.002, 0.0005}, {0.18, 0.18, 0.18},
                                     {0.9, 0.2, 0.05},   {1.0, 1.0, 1.0},        {0.0, 0.0, 3.0},
                                     {12.0, 4.0, 0.001}, {40.0, 50.0, 60.0}};

void expectFormula(const std::string& id, const std::function<glm::dvec3(glm::dvec3)>& formula,
                   const Values& values = {}) {
    for (const glm::dvec3& light : lights) {
        const glm::dvec3 found = shown(id, light, values);
        const glm::dvec3 right = formula(light);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(found[i], right[i], 1e-12 * std::max(right[i], 1.0)) << id << light.g;
        }
    }
}

/// K. Narkowicz's fraction.
TEST(ToneCurves, Aces_IsItsFormula) {
    expectFormula("aces", [](const glm::dvec3& x) {
        return (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14);
    });
}

/// Equation 4 of the paper: the luminance, and the colour by the ratio of the two.
TEST(ToneCurves, Reinhard_IsItsFormula) {
    for (const double white : {1.0, 4.0, 1000.0}) {
        const auto formula = [white](const glm::dvec3& c) {
            const double l = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
            const double display = l * (1.0 + l / (white * white)) / (1.0 + l);
            return l > 0.0 ? c * display / l : glm::dvec3(0.0);
        };
        expectFormula("reinhard", formula, {{"white", white}});
    }
}

/// As it was published: two matrices, and powers of x one by one.
TEST(ToneCurves, AgX_IsItsFormula) {
    const glm::dmat3 in(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                        0.0784335999999992, 0.878468636469772, 0.0784336, 0.0792237451477643,
                        0.0791661274605434, 0.879142973793104);
    const glm::dmat3 out(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                         -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                         -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
    expectFormula("agx", [&](const glm::dvec3& light) {
        glm::dvec3 v = in * light;
        for (int i = 0; i < 3; ++i) {
            const double stops = std::clamp(std::log2(v[i]), -12.47393, 4.026069);
            const double x = (stops + 12.47393) / (4.026069 + 12.47393);
            v[i] = 15.5 * std::pow(x, 6) - 40.14 * std::pow(x, 5) + 31.96 * std::pow(x, 4) -
                   6.868 * std::pow(x, 3) + 0.4298 * x * x + 0.1191 * x - 0.00232;
        }
        v = out * v;
        return glm::dvec3(std::pow(std::max(v.r, 0.0), 2.2), std::pow(std::max(v.g, 0.0), 2.2),
                          std::pow(std::max(v.b, 0.0), 2.2));
    });
}

/// What the specification's reference code makes of them, worked out by hand.
TEST(ToneCurves, KhronosNeutral_KeepsBaseColoursAndCompressesTheRest) {
    const glm::dvec3 base = shown("khronos-neutral", {0.44, 0.24, 0.14});
    EXPECT_NEAR(base.r, 0.40, 1e-12);
    EXPECT_NEAR(base.g, 0.20, 1e-12);
    EXPECT_NEAR(base.b, 0.10, 1e-12);
    // 0.96 -> 1 - 0.24^2 / (0.96 + 0.24 - 0.76)
    EXPECT_NEAR(shown("khronos-neutral", glm::dvec3(1.0)).g, 1.0 - 0.0576 / 0.44, 1e-12);
}

/// The curves of the catalogue, whatever they are.
template <class Check>
void forEachCurve(const Check& check) {
    std::size_t count = 0;
    for (const reference::Block& block : reference::blocks()) {
        if (block.kind == "tone") {
            SCOPED_TRACE(std::string(block.id));
            check(std::string(block.id));
            ++count;
        }
    }
    EXPECT_EQ(count, 4u);
}

TEST(ToneCurves, OfGrey_NeverFall) {
    forEachCurve([](const std::string& id) {
        double last = 0.0;
        for (double stops = -20.0; stops < 40.0; stops += 0.01) {
            const double next = shown(id, glm::dvec3(std::exp2(stops))).g;
            EXPECT_GE(next, last * (1.0 - 1e-12)) << stops;
            last = next;
        }
    });
}

TEST(ToneCurves, OfAnyLight_AreFiniteAndNeverNegative) {
    const double parts[] = {0.0, 1e-38, 1e-12, 0.01, 1.0, 65504.0, 1e30};
    forEachCurve([&parts](const std::string& id) {
        for (const double r : parts) {
            for (const double g : parts) {
                for (const double b : parts) {
                    const glm::dvec3 found = shown(id, {r, g, b});
                    for (int i = 0; i < 3; ++i) {
                        EXPECT_TRUE(std::isfinite(found[i]) && found[i] >= 0.0) << r << g << b;
                    }
                }
            }
        }
    });
}

TEST(ToneCurves, OfBlack_AreBlack) {
    forEachCurve(
        [](const std::string& id) { EXPECT_EQ(shown(id, glm::dvec3(0.0)), glm::dvec3(0.0)); });
}

/// Where their descriptors say that grey shows as white; Khronos' never does.
TEST(ToneCurves, White_IsReachedWhereTheDescriptorsSay) {
    constexpr double step = 0.5 / 255.0;
    const auto display = [](const std::string& id, double light) {
        return std::min(shown(id, glm::dvec3(light)).g, 1.0);
    };
    EXPECT_GT(display("agx", 16.3), std::pow(1.0 - step, 2.2));
    EXPECT_LT(display("agx", 12.0), std::pow(1.0 - step, 2.2));
    EXPECT_EQ(display("aces", 7.25), 1.0);
    EXPECT_LT(display("aces", 7.2), 1.0);
    EXPECT_NEAR(display("reinhard", 4.0), 1.0, 1e-12);
    EXPECT_LT(display("reinhard", 3.9), 1.0);
    EXPECT_LT(display("khronos-neutral", 1e6), 1.0);
}

} // namespace
} // namespace patina::physics::tone_values_test
