// SPDX-License-Identifier: GPL-3.0-or-later
// Up to four views, each with a material of its own.
#include <set>

#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "document/compare_edits.h"
#include "parameters/parameter_editor.h"
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
            waitFor(side);
        }
    }

    void waitFor(Side side) {
        const FrameLoop& frames = viewOf(side).frames();
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return frames.canDraw() && frames.isUpToDate(); }, waitMs));
    }

    QRgb middleOf(Side side) {
        const QImage picture = viewOf(side).grabPicture();
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

/// Each would draw the map for itself if they shared nothing.
TEST_F(CompareViews, OfOneScene_DrawItsShadowsOnce) {
    int drawnByA = 0;
    const FrameLoop& ofA = view().frames();
    QObject::connect(&ofA, &FrameLoop::frameDrawn, &window(),
                     [&] { drawnByA += ofA.report().shadowMaps; });
    document().setBlock(pathOf(kinds::shadows, 0), "hard");
    ASSERT_TRUE(QTest::qWaitFor([&] { return drawnByA > 0; }, waitMs));
    compareFour();
    EXPECT_EQ(drawnByA, 1);
    for (const Side side : {Side::B, Side::C, Side::D}) {
        EXPECT_EQ(viewOf(side).frames().report().shadowMaps, 0) << indexOf(side);
    }
}

/// The widgets lose their contexts, one after the other.
TEST_F(CompareViews, MovedToAnotherWindow_DrawAgain) {
    window().comparison().setComparing(true);
    settle();
    waitFor(Side::B);
    const QRgb before = middleOf(Side::B);
    QMainWindow other;
    other.resize(window().size());
    other.setCentralWidget(&window().views());
    other.show();
    for (const Side side : {Side::A, Side::B}) {
        waitFor(side);
        EXPECT_NEAR(qGray(middleOf(side)), qGray(before), 2);
    }
    window().setCentralWidget(&window().views()); // which owns it
}

TEST_F(CompareViews, EditOfD_ChangesNoOtherView) {
    compareFour();
    const std::array before{middleOf(Side::A), middleOf(Side::B), middleOf(Side::C)};
    const QRgb ofD = middleOf(Side::D);
    const int framesOfA = view().frames().frameCount();
    document().setValue(pathOf(kinds::models, 0, Side::D), "diffuse.color", glm::dvec3(0.05));
    settle();
    ASSERT_TRUE(QTest::qWaitFor([&] { return viewOf(Side::D).frames().isUpToDate(); }, waitMs));
    EXPECT_EQ(before, (std::array{middleOf(Side::A), middleOf(Side::B), middleOf(Side::C)}));
    EXPECT_NE(middleOf(Side::D), ofD);
    EXPECT_EQ(view().frames().frameCount(), framesOfA) << "nothing changed there";
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
    window().views().cameras().setLinked(false);
    wished.yaw += 30.0;
    Q_EMIT window().views().view(Side::D)->cameraWished(wished);
    EXPECT_EQ(viewOf(Side::D).camera().yaw, wished.yaw);
    EXPECT_NE(camera().yaw, wished.yaw);
    window().views().cameras().setLinked(true);
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

/// Links of views, in the window.
class OwnViews : public CompareViews {
  protected:
    void compareTwo() {
        window().comparison().setComparing(true);
        settle();
        waitForB();
    }

    void waitForB() {
        settle();
        waitFor(Side::B);
    }

    QAction* actionOfB(const char* name) {
        return window().views().second()->findChild<QAction*>(name);
    }
};

TEST_F(OwnViews, ExposureOfB_IsSeenThereAloneUntilItIsLinkedAgain) {
    compareTwo();
    const QRgb linked = middleOf(Side::B);
    const QRgb ofA = middleOf(Side::A);
    ASSERT_NEAR(qGray(linked), qGray(ofA), 2) << "views may be a pixel wider than others";
    actionOfB("ownExposure")->trigger();
    BlockPath stops = pathOf(settings::scene, 0, Side::B);
    stops.isOfView = true;
    document().setValue(stops, exposureSetting, 2.0);
    waitForB();
    EXPECT_GT(qGray(middleOf(Side::B)), qGray(linked) + 20);
    EXPECT_EQ(middleOf(Side::A), ofA);
    const auto* button = window().views().second()->findChild<QToolButton*>("links");
    EXPECT_EQ(button->text(), "Own exposure +2");
    actionOfB("relink")->trigger();
    waitForB();
    EXPECT_EQ(middleOf(Side::B), linked);
    EXPECT_EQ(button->text(), "Linked");
}

TEST_F(OwnViews, SliderOfTheMenu_ExposesTheViewInOneStep) {
    compareTwo();
    auto* stops = window().views().second()->findChild<ParameterEditor*>("ownStops");
    ASSERT_NE(stops, nullptr);
    EXPECT_FALSE(stops->isEnabled());
    actionOfB("ownExposure")->trigger();
    EXPECT_TRUE(stops->isEnabled());
    const int steps = document().undoStack().index();
    Q_EMIT stops->interactionBegan();
    for (const double value : {0.5, 1.0, 1.5}) {
        Q_EMIT stops->edited(value);
        EXPECT_EQ(document().scene(Side::B).exposure, value);
    }
    Q_EMIT stops->interactionEnded();
    EXPECT_EQ(document().undoStack().index(), steps + 1);
    EXPECT_EQ(document().scene().exposure, document().scene(Side::A).exposure);
}

TEST_F(OwnViews, KeptPicture_HasTheExposureOfItsView) {
    compareTwo();
    OwnView own;
    own.exposure = 2.0;
    setOwnView(document(), Side::B, own, "");
    const Image a = viewOf(Side::A).capture().picture(false);
    const Image b = viewOf(Side::B).capture().picture(false);
    const auto meanRed = [](const Image& image) {
        double red = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
            red += image.pixels[i];
        }
        return red / image.width / image.height;
    };
    EXPECT_GT(meanRed(a), 0.0);
    EXPECT_NEAR(meanRed(b) / meanRed(a), 4.0, 0.1);
}

TEST_F(OwnViews, EffectsPanel_SwitchesThoseOfTheActiveView) {
    compareTwo();
    actionOfB("ownEffects")->trigger();
    document().selection().setSide(Side::B);
    ASSERT_TRUE(document().state().ownViews[1].switchedOff);
    QDockWidget* dock = window().dock("effects");
    dock->show();
    dock->raise();
    settle();
    auto* list = dock->findChild<QTreeWidget*>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return list->topLevelItemCount() > 0; }, waitMs));
    settle(); // the panel takes its place beside the views
    newFrames();
    const QRgb before = middleOf(Side::A);
    QTreeWidgetItem* switched = nullptr;
    for (QTreeWidgetItemIterator it(list); *it != nullptr && switched == nullptr; ++it) {
        if ((*it)->flags().testFlag(Qt::ItemIsUserCheckable) &&
            (*it)->checkState(0) == Qt::Checked) {
            switched = *it;
        }
    }
    ASSERT_NE(switched, nullptr);
    switched->setCheckState(0, Qt::Unchecked);
    settle();
    EXPECT_EQ(document().state().ownViews[1].switchedOff->size(), 1u);
    EXPECT_NE(viewOf(Side::B).viewed().sources().scene(), document().scene());
    EXPECT_EQ(viewOf(Side::A).viewed().sources().scene(), document().scene());
    EXPECT_EQ(middleOf(Side::A), before);
    document().undoStack().undo();
    EXPECT_TRUE(document().state().ownViews[1].switchedOff->empty());
}

} // namespace
} // namespace patina::tests::compare_views_test
