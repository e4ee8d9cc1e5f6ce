// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::transparency_test {
namespace {

/// Of a torus, of which several layers are seen through each other.
std::vector<std::string> blending(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", gold,         "--size",      "32x32",
                                       "--mesh", "builtin:torus", "--set", "opacity=0.5",
                                       "-o",     "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(TransparencyOption, EachWay_GivesAPictureOfItsOwn) {
    const Outcome sorted = patina(blending({}));
    const Outcome peeled = patina(blending({"--transparency", "peeled"}));
    const Outcome weighted = patina(blending({"--transparency", "weighted"}));
    ASSERT_EQ(peeled.exitCode, 0) << peeled.err;
    ASSERT_EQ(weighted.exitCode, 0) << weighted.err;
    EXPECT_NE(peeled.out, sorted.out);
    EXPECT_NE(weighted.out, sorted.out);
    EXPECT_NE(weighted.out, peeled.out);
    EXPECT_EQ(patina(blending({"--transparency", "sorted"})).out, sorted.out);
}

TEST(TransparencyOption, Layers_AreSet) {
    const Outcome one =
        patina(blending({"--transparency", "peeled", "--set", "transparency.layers=1"}));
    ASSERT_EQ(one.exitCode, 0) << one.err;
    EXPECT_NE(one.out, patina(blending({"--transparency", "peeled"})).out);
}

TEST(TransparencyOption, OfASolidObject_ChangesNothing) {
    const std::vector<std::string> solid{"render", gold, "--size", "32x32", "-o", "-"};
    std::vector<std::string> peeled = solid;
    peeled.insert(peeled.end(), {"--transparency", "peeled"});
    EXPECT_EQ(patina(peeled).out, patina(solid).out);
}

TEST(TransparencyOption, UnknownName_IsAnErrorWithTheNames) {
    const Outcome outcome = patina(blending({"--transparency", "magic"}));
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("sorted, peeled, weighted"), std::string::npos) << outcome.err;
}

TEST(TransparencyOption, ValueWithoutAChoice_IsAnErrorThatNamesTheOption) {
    const Outcome outcome = patina(blending({"--set", "transparency.layers=1"}));
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("--transparency"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::transparency_test
