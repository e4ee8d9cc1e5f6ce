// SPDX-License-Identifier: GPL-3.0-or-later
// What a budget for time or error buys.
#include <QComboBox>

#include "ui/accuracy_fixture.h"

namespace patina::tests::accuracy_budget_test {
namespace {

TEST_F(AccuracyPanel, BudgetsInAGermanLocale_TakeEitherMarkAndShowAPoint) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    BoundBox& time = bound("milliseconds");
    typeInto(time, "1.5");
    EXPECT_EQ(time.value(), 1.5);
    typeInto(time, "2,5");
    EXPECT_EQ(time.value(), 2.5);
    EXPECT_EQ(time.text(), "2.5");
    typeInto(time, "0.001");
    EXPECT_EQ(time.value(), 0.001);
    QLocale::setDefault(before);
}

TEST_F(AccuracyPanel, ErrorBudget_IsTypedAsAFractionANumberOrPercents) {
    BoundBox& share = bound("share");
    const auto typed = [&](const QString& text) {
        typeInto(share, text);
        return share.value();
    };
    EXPECT_EQ(share.text(), "1/255");
    EXPECT_DOUBLE_EQ(typed("5 %"), 0.05);
    EXPECT_EQ(share.text(), "5 %");
    EXPECT_DOUBLE_EQ(typed("1/255"), 1.0 / 255.0);
    EXPECT_EQ(share.text(), "1/255");
    EXPECT_DOUBLE_EQ(typed("0.004"), 0.004);
    EXPECT_DOUBLE_EQ(typed("0,6 %"), 0.006);
    EXPECT_DOUBLE_EQ(typed("nothing"), 0.006);
}

TEST_F(AccuracyPanel, TimeBudget_MayBeLongAndShort) {
    BoundBox& time = bound("milliseconds");
    typeInto(time, "20000");
    EXPECT_EQ(time.value(), 20000.0);
    typeInto(time, "0.00002");
    EXPECT_EQ(time.value(), 0.00002);
    typeInto(time, "0");
    EXPECT_GT(time.value(), 0.0);
}

TEST_F(MeasuredPanel, UseIt_UsesTheBudgetThatIsTyped) {
    ASSERT_TRUE(measureUntilFaster("near")) << state().toStdString();
    typeInto(bound("share"), "1/255");
    press("Use it");
    ASSERT_NE(level(), "");
    BoundBox& share = bound("share");
    window().activateWindow();
    share.setFocus();
    ASSERT_TRUE(QTest::qWaitFor([&] { return share.hasFocus(); }));
    share.selectAll();
    QTest::keyClicks(&share, "0.01 %"); // the exact way alone, whatever the times are
    for (QToolButton* button : budget().findChildren<QToolButton*>()) {
        QTest::mouseClick(button, Qt::LeftButton);
    }
    EXPECT_EQ(level(), "");
}

TEST_F(MeasuredPanel, ErrorBudget_PicksTheFastestWayWithinIt) {
    ASSERT_TRUE(measureUntilFaster("near")) << state().toStdString();
    typeInto(bound("share"), "1/255");
    ASSERT_TRUE(budget().answer().has_value());
    EXPECT_TRUE(budget().answer()->fits);
    EXPECT_EQ(static_cast<int>(budget().answer()->point), pointOf("near"));
    press("Use it");
    EXPECT_EQ(level(), "near");
}

TEST_F(MeasuredPanel, CardThatIsNotHere_HasItsTimesItsFrontAndItsBudget) {
    auto& card = *budget().findChild<QComboBox*>("card");
    card.setCurrentIndex(card.findText("Steam Deck (RDNA 2)"));
    const CostChart& drawn = dock().drawnChart();
    ASSERT_EQ(drawn.points.size(), 3u) << state().toStdString();
    EXPECT_EQ(drawn.predictedFor, "Steam Deck (RDNA 2)");
    EXPECT_TRUE(state().contains("predicted")) << state().toStdString();
    const CostPoint* near = drawn.find({{"work", "near"}});
    const CostPoint* far = drawn.find({{"work", "far"}});
    ASSERT_TRUE(near != nullptr && far != nullptr);
    EXPECT_EQ(errorOf(*near), errorOfLevel("near")) << "errors are those measured here";
    EXPECT_LT(far->cost.ratio.median, 0.5);
    EXPECT_EQ(list().topLevelItemCount(), 3);
    // The far way alone is quick enough for this budget, at 1080p as at 1440p.
    typeInto(bound("milliseconds"), QString::number(1.05 * far->cost.milliseconds.median));
    ASSERT_TRUE(budget().answer().has_value());
    EXPECT_TRUE(budget().answer()->fits);
    EXPECT_EQ(&drawn.points[budget().answer()->point], far);
    press("Use it");
    EXPECT_EQ(level(), "far");
    card.setCurrentIndex(0);
    EXPECT_TRUE(dock().drawnChart().predictedFor.empty());
    EXPECT_EQ(dock().drawnChart(), dock().chart());
}

TEST_F(MeasuredPanel, TimeBudgetThatNothingMeets_SaysSo) {
    typeInto(bound("milliseconds"), "1e-6");
    ASSERT_TRUE(budget().answer().has_value());
    EXPECT_FALSE(budget().answer()->fits);
    const QString text = budget().findChild<QLabel*>("budget")->text();
    EXPECT_TRUE(text.startsWith("Nothing fits")) << text.toStdString();
}

} // namespace
} // namespace patina::tests::accuracy_budget_test
