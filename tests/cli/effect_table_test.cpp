// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the effects in a table for people.
#include "cli/effect_table.h"

#include <gtest/gtest.h>

namespace patina::tests {
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

} // namespace
} // namespace patina::tests
