// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::shells_test {
namespace {

std::vector<std::string> rendering(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", gold, "--size", "32x32", "-o", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(ShellsOption, Chosen_ShowsInThePicture) {
    const Outcome furry = patina(rendering({"--shells", "fur", "--set", "shells.layers=8"}));
    ASSERT_EQ(furry.exitCode, 0) << furry.err;
    const Outcome bare = patina(rendering({}));
    EXPECT_NE(furry.out, bare.out);
    const Outcome none = patina(rendering({"--shells", "fur", "--set", "shells.strand.length=0"}));
    ASSERT_EQ(none.exitCode, 0) << none.err;
    EXPECT_EQ(none.out, bare.out);
}

TEST(EffectsSource, OfFur_HasTheStagesOfItsFins) {
    const Outcome outcome = patina({"effects", gold, "--shells", "fur", "--source"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("// ======== fins: geometry stage"), std::string::npos);
    EXPECT_NE(outcome.out.find("effect shells/fur"), std::string::npos);
}

} // namespace
} // namespace patina::tests::shells_test
