// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the effects in a table for people.
#include "cli/effect_table.h"

#include <gtest/gtest.h>

namespace patina::tests::effect_table_test {
namespace {

EffectRow row(const std::string& effect, const std::string& within = "") {
    return {{effect, "", "Why."}, true, true, within};
}

TEST(EffectTable, WhatLiesWithin_FollowsWhatItIsWithin) {
    EffectTable table;
    table.rows = {row("shadow", "light"), row("model"), row("lobe", "fresnel"),
                  row("fresnel", "model"), row("light"), row("lost", "nothing")};
    table.rows.push_back({{"fog", "", "None."}, false, false, ""});
    EXPECT_EQ(tableText(table), "object 1 of 1\n"
                                "model        Why.\n"
                                "  fresnel    Why.\n"
                                "    lobe     Why.\n"
                                "light        Why.\n"
                                "  shadow     Why.\n"
                                "not in: fog  None.\n"
                                "lost         Why.\n");
}

/// Neither is above the other, and both are there.
TEST(EffectTable, EffectsWithinEachOther_AreListedOnce) {
    EffectTable table;
    table.rows = {row("a", "b"), row("b", "a")};
    EXPECT_EQ(tableText(table), "object 1 of 1\n"
                                "a    Why.\n"
                                "  b  Why.\n");
}

/// What too few frames tell is marked, and what none tell says so.
TEST(EffectTable, TooFewPairs_AreMarked) {
    EffectTable table;
    table.rows = {row("sure"), row("unsure"), row("unmeasured")};
    table.costs = EffectCosts{{10.0, 9.0, 11.0},
                              4.0,
                              {{"sure", {4.0, 3.0, 5.0}, 6}, {"unsure", {2.0, 1.0, 3.0}, 5}},
                              {64, 64},
                              0,
                              8.0,
                              "clock",
                              {}};
    const std::string text = tableText(table);
    EXPECT_NE(text.find("4.000 ms  40.0 % (3.000 .. 5.000)"), std::string::npos) << text;
    EXPECT_NE(text.find("2.000 ms  20.0 % ! (1.000 .. 3.000)"), std::string::npos) << text;
    EXPECT_NE(text.find("no time for it"), std::string::npos) << text;
    EXPECT_NE(text.find("! too few pairs"), std::string::npos) << text;
    EXPECT_EQ(text.find("which is no effect"), std::string::npos) << text;
    const nlohmann::json json = tableJson(table);
    EXPECT_EQ(json["effects"][0]["sure"], true);
    EXPECT_EQ(json["effects"][1]["sure"], false);
    EXPECT_EQ(json["effects"][1]["pairs"], 5);
    EXPECT_EQ(json["costs"]["secondsNeeded"], 8.0);
}

} // namespace
} // namespace patina::tests::effect_table_test
