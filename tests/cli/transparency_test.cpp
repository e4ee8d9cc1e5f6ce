// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests {
namespace {

const std::string gold = shipped("presets/cook-torrance/gold.patina.json").string();

/// Of a torus, of which several layers are seen through each other.
std::vector<std::string> rendering(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", gold,         "--size",      "32x32",
                                       "--mesh", "builtin:torus", "--set", "opacity=0.5",
                                       "-o",     "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(TransparencyOption, EachWay_GivesAPictureOfItsOwn) {
    const Outcome sorted = patina(rendering({}));
    const Outcome peeled = patina(rendering({"--transparency", "peeled"}));
    const Outcome weighted = patina(rendering({"--transparency", "weighted"}));
    ASSERT_EQ(peeled.exitCode, 0) << peeled.err;
    ASSERT_EQ(weighted.exitCode, 0) << weighted.err;
    EXPECT_NE(peeled.out, sorted.out);
    EXPECT_NE(weighted.out, sorted.out);
    EXPECT_NE(weighted.out, peeled.out);
    EXPECT_EQ(patina(rendering({"--transparency", "sorted"})).out, sorted.out);
}

TEST(TransparencyOption, Layers_AreSet) {
    const Outcome one =
        patina(rendering({"--transparency", "peeled", "--set", "transparency.layers=1"}));
    ASSERT_EQ(one.exitCode, 0) << one.err;
    EXPECT_NE(one.out, patina(rendering({"--transparency", "peeled"})).out);
}

TEST(TransparencyOption, OfASolidObject_ChangesNothing) {
    const std::vector<std::string> solid{"render", gold, "--size", "32x32", "-o", "-"};
    std::vector<std::string> peeled = solid;
    peeled.insert(peeled.end(), {"--transparency", "peeled"});
    EXPECT_EQ(patina(peeled).out, patina(solid).out);
}

TEST(TransparencyOption, UnknownName_IsAnErrorWithTheNames) {
    const Outcome outcome = patina(rendering({"--transparency", "magic"}));
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("sorted, peeled, weighted"), std::string::npos) << outcome.err;
}

TEST(TransparencyOption, ValueWithoutAChoice_IsAnErrorThatNamesTheOption) {
    const Outcome outcome = patina(rendering({"--set", "transparency.layers=1"}));
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("--transparency"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests
