// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "physics_cases.h"

namespace patina::physics::gloss_test {
namespace {

using Numbers = std::vector<double>;

TEST(Gloss, Multiplying_ScalesEveryChannel) {
    EXPECT_EQ(call("glossed", {4.0, 2.0, 0.5, 0.25, 0.0, 0.5}), (Numbers{1.0, 0.5, 0.125}));
}

TEST(Gloss, Limiting_CutsOnlyWhatIsBrighterThanItsShareOfWhite) {
    EXPECT_EQ(call("glossed", {4.0, 0.125, 0.0, 0.5, 1.0, 0.5}), (Numbers{0.25, 0.125, 0.0}));
}

} // namespace
} // namespace patina::physics::gloss_test
