// SPDX-License-Identifier: GPL-3.0-or-later
// How far A and B are apart, in numbers.
#include <QLabel>
#include <QTest>

#include "ui/window_fixture.h"
#include "viewport/comparison_meter.h"
#include "viewport/comparison_text.h"

namespace patina::tests::compare_numbers_test {
namespace {

constexpr int waitMs = 60000;

class CompareNumbers : public WindowFixture {
  protected:
    const ComparisonNumbers& numbers() { return window().views().meter()->numbers(); }
    QLabel& label() { return *window().findChild<QLabel*>("statusComparison"); }

    bool waitForDistance() {
        return QTest::qWaitFor([this] { return numbers().distance.has_value(); }, waitMs);
    }

    void putOtherOnB() {
        window().files().applyPreset(QString::fromStdString(otherPreset(document()).string()),
                                     Side::B);
    }
};

TEST_F(CompareNumbers, SameMaterials_LookTheSame) {
    window().comparison().setComparing(true);
    ASSERT_TRUE(waitForDistance());
    EXPECT_EQ(numbers().distance->flip, 0.0);
    EXPECT_EQ(numbers().distance->largest, 0.0);
    EXPECT_TRUE(label().text().contains("looks the same")) << label().text().toStdString();
}

TEST_F(CompareNumbers, OtherMaterial_IsAwayAndTakesTime) {
    window().comparison().setComparing(true);
    putOtherOnB();
    ASSERT_TRUE(waitForDistance());
    EXPECT_GT(numbers().distance->flip, 0.0);
    EXPECT_LT(numbers().distance->similarity, 1.0);
    EXPECT_GE(numbers().distance->largest, numbers().distance->percentile99);
    ASSERT_TRUE(QTest::qWaitFor([this] { return numbers().time.has_value(); }, waitMs));
    EXPECT_GT(numbers().time->ratio.median, 0.0);
    EXPECT_TRUE(label().text().startsWith("B takes")) << label().text().toStdString();
    EXPECT_TRUE(label().text().contains("FLIP")) << label().text().toStdString();
}

TEST_F(CompareNumbers, Change_TakesTheOldNumbersAway) {
    window().comparison().setComparing(true);
    ASSERT_TRUE(waitForDistance());
    putOtherOnB();
    EXPECT_FALSE(numbers().distance.has_value());
    EXPECT_TRUE(label().isHidden());
}

TEST_F(CompareNumbers, Pointer_ReadsBothPictures) {
    window().comparison().setComparing(true);
    putOtherOnB();
    ASSERT_TRUE(waitForDistance());
    QTest::mouseMove(&view(), view().rect().center() + QPoint(1, 1));
    QTest::mouseMove(&view(), view().rect().center());
    EXPECT_TRUE(QTest::qWaitFor([this] { return label().text().startsWith("A "); }, 2000))
        << label().text().toStdString();
    EXPECT_TRUE(label().text().contains("apart"));
}

TEST(ComparisonText, FasterAndAway_SaysBoth) {
    const ComparisonNumbers numbers{Side::B, PictureDistance{0.3, 0.1, 0.01, 0.0123, 0.99},
                                    TimeRatio{{0.69, 0.67, 0.71}, 12}};
    EXPECT_EQ(comparisonText(numbers), "B takes 31 % less time and is FLIP 0.0123 away");
}

TEST(ComparisonText, TimesThatCannotBeTold_TakeAsLong) {
    const ComparisonNumbers numbers{Side::B, PictureDistance{}, TimeRatio{{1.05, 0.97, 1.1}, 12}};
    EXPECT_EQ(comparisonText(numbers), "B takes as long and looks the same");
}

} // namespace
} // namespace patina::tests::compare_numbers_test
