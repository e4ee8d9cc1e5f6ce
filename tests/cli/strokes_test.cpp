// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::strokes_test {
namespace {

TEST(StrokesOption, Chosen_ShowsInThePicture) {
    const std::vector<std::string> plain{"render", gold, "--size", "32x32", "-o", "-"};
    std::vector<std::string> dotted = plain;
    dotted.insert(dotted.end(), {"--strokes", "stipple", "--set", "strokes.marks=50"});
    const Outcome with = patina(dotted);
    ASSERT_EQ(with.exitCode, 0) << with.err;
    EXPECT_NE(with.out, patina(plain).out);
}

TEST(StrokesOption, TenMillionMarks_AreRefusedWithTheRange) {
    const Outcome outcome = patina({"render", gold, "--size", "8x8", "-o", "-", "--strokes",
                                    "stipple", "--set", "strokes.density=1e7"});
    EXPECT_NE(outcome.err.find("10000"), std::string::npos) << outcome.err;
}

TEST(EffectsSource, OfStrokes_HasTheStagesOfItsMarks) {
    const Outcome outcome = patina({"effects", gold, "--strokes", "stipple", "--source"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("// ======== marks: vertex stage"), std::string::npos);
    EXPECT_NE(outcome.out.find("effect strokes/stipple"), std::string::npos);
}

} // namespace
} // namespace patina::tests::strokes_test
