// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "core/value.h"

namespace patina::tests::value_test {
namespace {

TEST(RoundedValue, OfNumbersThatNoFloatHolds_HasTheNearestFloats) {
    const glm::dvec3 exact(0.76484218728448838, 0.64421768723769002, 1e-8);
    EXPECT_EQ(roundedToFloat(Value(exact.x)), Value(double(float(exact.x))));
    const auto triple = std::get<glm::dvec3>(roundedToFloat(Value(exact)));
    const auto pair = std::get<glm::dvec2>(roundedToFloat(Value(glm::dvec2(exact))));
    // Through memory, so that no compiler can take the conversion back.
    for (int i = 0; i < 3; ++i) {
        volatile float nearest = 0.0f;
        nearest = static_cast<float>(exact[i]);
        EXPECT_EQ(triple[i], double(nearest)) << i;
        EXPECT_EQ(i < 2 ? pair[i] : double(nearest), double(nearest)) << i;
    }
}

TEST(RoundedValue, OfAWord_IsTheWord) {
    EXPECT_EQ(roundedToFloat(Value(std::string("mixed"))), Value(std::string("mixed")));
}

} // namespace
} // namespace patina::tests::value_test
