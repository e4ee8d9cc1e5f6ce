// SPDX-License-Identifier: GPL-3.0-or-later
// What a contact sheet may go through.
#include "sheet/sheet_offers.h"

#include <gtest/gtest.h>

#include "sheet/sheet_plan.h"
#include "sheet_fixture.h"

namespace patina::sheet_offers_test {
namespace {

std::vector<AxisOffer> offers() {
    return axisOffers(tests::sheetScene(), 0, *tests::sheetCatalog());
}

const AxisOffer* offerCalled(const std::vector<AxisOffer>& all, const std::string& label) {
    const auto found = std::ranges::find(all, label, &AxisOffer::label);
    return found == all.end() ? nullptr : &*found;
}

TEST(SheetOffers, EachOfThem_CanBePlanned) {
    const auto all = offers();
    EXPECT_GE(all.size(), 6u);
    for (const AxisOffer& offer : all) {
        const auto plan =
            SheetPlan::of(Sheet{.x = offer.axis}, tests::sheetScene(), 0, tests::sheetCatalog());
        ASSERT_TRUE(plan) << offer.label << ": " << text(plan.error());
        EXPECT_GE(plan->columns(), 2) << offer.label;
    }
}

TEST(SheetOffers, Numbers_HaveTheirSlidersRange) {
    const auto all = offers();
    const AxisOffer* sheen = offerCalled(all, "Sheen");
    ASSERT_NE(sheen, nullptr);
    ASSERT_TRUE(sheen->of);
    EXPECT_EQ(sheen->axis.range->from, sheen->of->softMin);
    EXPECT_EQ(sheen->axis.range->to, sheen->of->softMax);
    EXPECT_FALSE(offerCalled(all, "Weave")->of);
    EXPECT_EQ(offerCalled(all, "Tint"), nullptr); // a colour has no steps of its own
}

TEST(SheetOffers, AccuracyChoice_IsOfferedByItself) {
    const auto all = offers();
    const AxisOffer* power = offerCalled(all, "Accuracy: Power");
    ASSERT_NE(power, nullptr);
    EXPECT_EQ(power->axis, (SheetAxis{AxisKind::Value, "power", {}, {}}));
}

} // namespace
} // namespace patina::sheet_offers_test
