// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::outline_test {
namespace {

std::vector<std::string> rendering(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", gold, "--size", "32x32", "-o", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(OutlineOption, Chosen_ShowsInThePicture) {
    const Outcome lined = patina(rendering({"--outline", "ink-line"}));
    ASSERT_EQ(lined.exitCode, 0) << lined.err;
    EXPECT_NE(lined.out, patina(rendering({})).out);
}

TEST(OutlineOption, WithoutWidths_IsThePictureWithoutIt) {
    const Outcome none = patina(rendering({"--outline", "ink-line", "--set", "outline.width=0",
                                           "--set", "outline.crease.width=0"}));
    ASSERT_EQ(none.exitCode, 0) << none.err;
    EXPECT_EQ(none.out, patina(rendering({})).out);
}

TEST(OutlineOption, OfAnUnknownKind_IsAMistake) {
    const Outcome outcome = patina(rendering({"--outline", "ink-lin"}));
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("ink-line"), std::string::npos) << outcome.err;
}

TEST(EffectsSource, OfAnOutline_HasItsThreeStages) {
    const Outcome outcome = patina({"effects", gold, "--outline", "ink-line", "--source"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("// ======== outline: geometry stage"), std::string::npos);
    EXPECT_NE(outcome.out.find("effect outline/ink-line"), std::string::npos);
}

} // namespace
} // namespace patina::tests::outline_test
