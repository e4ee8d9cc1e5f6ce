// SPDX-License-Identifier: GPL-3.0-or-later
// What a contact sheet may go through.
#include "sheet/sheet_offers.h"

#include <algorithm>
#include <array>

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

TEST(SheetOffers, ValuesThatTheMaterialDoesNotRead_SaySo) {
    Scene scene = tests::sheetScene();
    const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}};
    const Catalog shipped = loadCatalog(roots);
    scene.objects[0].material = defaultMaterial(*shipped.find(kinds::models, "ward"));
    const auto called = [&](const std::string& id) {
        const auto all = axisOffers(scene, 0, shipped);
        return std::ranges::find(all, id, [](const AxisOffer& each) { return each.axis.value; })
            ->counts;
    };
    EXPECT_TRUE(called("roughness.x"));
    EXPECT_FALSE(called("roughness"));
    scene.objects[0].material.model.parameters["grain"] = std::string("isotropic");
    EXPECT_FALSE(called("roughness.x"));
    EXPECT_TRUE(called("roughness"));
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
