// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::refraction_test {
namespace {

/// In surroundings that are not the same everywhere: else nothing is refracted that could be seen.
std::vector<std::string> refracting(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", "--model",     "lambert",       "--size",
                                       "32x32",  "--set",       "opacity=0.1",   "--environment",
                                       "studio", "-o",          "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(RefractionOption, EachKind_GivesAPictureOfItsOwn) {
    const Outcome straight = patina(refracting({}));
    const Outcome solid = patina(refracting({"--refraction", "solid-body"}));
    const Outcome pane = patina(refracting({"--refraction", "thin-pane"}));
    ASSERT_EQ(solid.exitCode, 0) << solid.err;
    ASSERT_EQ(pane.exitCode, 0) << pane.err;
    EXPECT_NE(solid.out, straight.out);
    EXPECT_NE(pane.out, straight.out);
    EXPECT_NE(pane.out, solid.out);
}

TEST(RefractionOption, Values_AreSet) {
    const Outcome usual = patina(refracting({"--refraction", "solid-body"}));
    const Outcome red =
        patina(refracting({"--refraction", "solid-body", "--set", "refraction.tint=1,0.1,0.1"}));
    ASSERT_EQ(red.exitCode, 0) << red.err;
    EXPECT_NE(red.out, usual.out);
}

TEST(RefractionOption, UnknownName_IsAnError) {
    EXPECT_NE(patina(refracting({"--refraction", "magic"})).exitCode, 0);
}

} // namespace
} // namespace patina::tests::refraction_test
