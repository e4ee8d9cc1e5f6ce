// SPDX-License-Identifier: GPL-3.0-or-later
// Up to four views, each with a material of its own.
#include <set>

#include <QComboBox>
#include <QTest>

#include "ui/window_fixture.h"
#include "viewport/views_capture.h"

namespace patina::tests::compare_views_test {
namespace {

constexpr int waitMs = 20000;

class CompareViews : public WindowFixture {
  protected:
    Viewport& viewOf(Side side) { return window().views().view(side)->viewport(); }

    bool isShown(Side side) {
        SideView* view = window().views().view(side);
        return view != nullptr && view->isVisible();
    }

    /// Four views, of which each has another colour.
    void compareFour() {
        window().comparison().setSideCount(4);
        settle();
        const glm::dvec3 colours[] = {
            {0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.8}, {0.7, 0.7, 0.1}};
        for (const Side side : sides) {
            document().setModel(side, "lambert");
            document().setValue(pathOf(kinds::models, 0, side), "diffuse.color",
                                colours[indexOf(side)]);
        }
        settle();
        for (const Side side : sides) {
            ASSERT_TRUE(
                QTest::qWaitFor([&] { return viewOf(side).frames().isUpToDate(); }, waitMs));
        }
    }

    QRgb middleOf(Side side) {
        const QImage picture = viewOf(side).grabFramebuffer();
        return picture.pixel(picture.rect().center());
    }
};

TEST_F(CompareViews, Four_ShowAMaterialEach) {
    compareFour();
    std::set<QRgb> seen;
    for (const Side side : sides) {
        EXPECT_TRUE(isShown(side));
        seen.insert(middleOf(side));
    }
    EXPECT_EQ(seen.size(), sides.size());
}

TEST_F(CompareViews, EditOfD_ChangesNoOtherView) {
    compareFour();
    const std::array before{middleOf(Side::A), middleOf(Side::B), middleOf(Side::C)};
    const QRgb ofD = middleOf(Side::D);
    document().setValue(pathOf(kinds::models, 0, Side::D), "diffuse.color", glm::dvec3(0.05));
    settle();
    ASSERT_TRUE(QTest::qWaitFor([&] { return viewOf(Side::D).frames().isUpToDate(); }, waitMs));
    EXPECT_EQ(before, (std::array{middleOf(Side::A), middleOf(Side::B), middleOf(Side::C)}));
    EXPECT_NE(middleOf(Side::D), ofD);
}

TEST_F(CompareViews, ChosenInTheBar_StandInAGridOrARow) {
    window().comparison().setComparing(true);
    auto* count = window().findChild<QComboBox*>("compareCount");
    count->setFocus();
    QTest::keyClick(count, Qt::Key_End);
    ASSERT_EQ(document().shownSides(), sides.size());
    settle();
    const auto placeOf = [this](Side side) { return viewOf(side).mapTo(&window(), QPoint(0, 0)); };
    EXPECT_GT(placeOf(Side::D).y(), placeOf(Side::B).y());
    EXPECT_EQ(placeOf(Side::D).x(), placeOf(Side::B).x());
    EXPECT_NEAR(viewOf(Side::D).height(), viewOf(Side::B).height(), 1);
    EXPECT_NEAR(viewOf(Side::D).width(), viewOf(Side::B).width(), 1);
    CompareLook look = window().views().look();
    look.arrangement = ViewArrangement::Row;
    window().views().setLook(look);
    settle();
    EXPECT_EQ(placeOf(Side::D).y(), placeOf(Side::B).y());
    EXPECT_GT(placeOf(Side::D).x(), placeOf(Side::C).x());
}

TEST_F(CompareViews, MoreAndFewer_AreOneStepEach) {
    window().comparison().setSideCount(3);
    EXPECT_EQ(document().undoStack().index(), 1);
    EXPECT_TRUE(isShown(Side::C));
    document().undoStack().undo();
    EXPECT_EQ(document().shownSides(), 1u);
    EXPECT_FALSE(isShown(Side::B) || isShown(Side::C));
    document().undoStack().redo();
    EXPECT_EQ(document().shownSides(), 3u);
}

TEST_F(CompareViews, LinkedCameras_MoveTogetherAndAlone) {
    window().comparison().setSideCount(4);
    settle();
    Camera wished = camera();
    wished.yaw += 30.0;
    Q_EMIT window().views().view(Side::D)->cameraWished(wished);
    EXPECT_EQ(camera().yaw, wished.yaw);
    EXPECT_EQ(viewOf(Side::C).camera(), camera());
    window().views().setCamerasLinked(false);
    wished.yaw += 30.0;
    Q_EMIT window().views().view(Side::D)->cameraWished(wished);
    EXPECT_EQ(viewOf(Side::D).camera().yaw, wished.yaw);
    EXPECT_NE(camera().yaw, wished.yaw);
    window().views().setCamerasLinked(true);
    EXPECT_EQ(viewOf(Side::D).camera(), camera());
}

TEST_F(CompareViews, Wipe_IsOfAAndBAndGivesTheOthersBack) {
    window().comparison().setSideCount(4);
    CompareLook look = window().views().look();
    look.mode = CompareMode::Wipe;
    window().views().setLook(look);
    settle();
    EXPECT_FALSE(isShown(Side::C) || isShown(Side::D));
    look.mode = CompareMode::SideBySide;
    window().views().setLook(look);
    settle();
    for (const Side side : sides) {
        EXPECT_TRUE(isShown(side)) << indexOf(side);
    }
}

TEST_F(CompareViews, ThirdView_IsSeenAfterAWipe) {
    window().comparison().setComparing(true);
    CompareLook look = window().views().look();
    look.mode = CompareMode::Wipe;
    window().views().setLook(look);
    window().comparison().setSideCount(3);
    EXPECT_EQ(window().views().look().mode, CompareMode::SideBySide);
    EXPECT_TRUE(isShown(Side::B) && isShown(Side::C));
}

TEST_F(CompareViews, ExportedPicture_HasAllFour) {
    compareFour();
    Image image;
    bool isTaken = false;
    ViewsCapture capture(window().views());
    capture.start(false, [&](Image picture) {
        image = std::move(picture);
        isTaken = true;
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return isTaken; }, waitMs));
    EXPECT_EQ(image.width, viewOf(Side::A).width() + viewOf(Side::B).width());
    EXPECT_EQ(image.height, viewOf(Side::A).height() + viewOf(Side::C).height());
}

} // namespace
} // namespace patina::tests::compare_views_test
