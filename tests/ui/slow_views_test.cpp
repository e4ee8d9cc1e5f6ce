// SPDX-License-Identifier: GPL-3.0-or-later
// Views of the default scene that are so large that a software driver takes long for a frame.
#include <algorithm>
#include <optional>
#include <vector>

#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "document/scene_edits.h"
#include "ui/window_fixture.h"

namespace patina::tests::slow_views_test {
namespace {

constexpr int limitMs = 60000;
constexpr QSize large{1500, 950};

class SlowViews : public WindowFixture {
  protected:
    void SetUp() override {
        document().setBlock(pathOf(kinds::shadows, 0), "soft");
        window().resize(large);
        ASSERT_TRUE(rest());
    }

    bool rest() {
        return QTest::qWaitFor(
            [this] {
                const auto views = window().views().views();
                return std::ranges::all_of(views, [](SideView* view) {
                    return view->isHidden() || view->viewport().frames().isUpToDate();
                });
            },
            limitMs);
    }
};

TEST_F(SlowViews, ResizedWhileASketchIsDrawn_TakeNoWholeFrameForTheSketch) {
    std::vector<QImage> sketches;
    QObject::connect(&view().frames(), &FrameLoop::sketchDrawn, &view(),
                     [&] { sketches.push_back(view().frames().surface().picture()); });
    view().frames().announceScene();
    const bool isSketching =
        QTest::qWaitFor([&] { return view().frames().isDrawing(); }, 200) && sketches.empty();
    QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
    sketches.clear();
    window().resize(large - QSize(40, 30));
    ASSERT_TRUE(rest());
    EXPECT_EQ(frames.count(), 1);
    const QImage whole = view().grabPicture().convertToFormat(QImage::Format_RGB32);
    ASSERT_LE(sketches.size(), 1U);
    EXPECT_TRUE(!isSketching || sketches.size() == 1) << "the sketch that was dropped comes again";
    for (const QImage& sketch : sketches) {
        EXPECT_NE(sketch, whole);
    }
}

/// The steps of a slow material may take long each, and the window's new part would be empty.
TEST_F(SlowViews, ResizedBeforeTheWholeFrame_ShowTheSketchStretchedBeforeTheyDraw) {
    FrameLoop& frames = view().frames();
    QSignalSpy sketches(&frames, &FrameLoop::sketchDrawn);
    frames.announceScene();
    ASSERT_TRUE(sketches.wait(limitMs));
    ASSERT_FALSE(frames.isUpToDate());
    std::optional<bool> wasDrawing;
    QSize shown;
    QObject::connect(&frames.surface(), &ViewSurface::shown, &view(), [&] {
        if (!wasDrawing) {
            wasDrawing = frames.isDrawing() || sketches.count() > 1;
            shown = frames.surface().picture().size();
        }
    });
    window().resize(large - QSize(300, 200));
    ASSERT_TRUE(rest());
    ASSERT_TRUE(wasDrawing);
    EXPECT_FALSE(*wasDrawing) << "the next sketch had been begun";
    EXPECT_EQ(shown, view().size());
}

/// Dropping the sketch for every move of the window's edge would show nothing until it rests.
TEST_F(SlowViews, ResizedAllTheTimeBeforeTheirFirstPicture_StillGetOne) {
    for (const Side side : {Side::A, Side::B}) {
        document().setModel(side, "he-torrance");
        document().setValue(pathOf(kinds::models, 0, side), "sigma0",
                            1.0); // adds up a hundred terms
    }
    for (int lamp = 0; lamp < 6; ++lamp) {
        addLight(document(), "point");
    }
    window().comparison().setComparing(true);
    FrameLoop& frames = secondView().frames();
    QSignalSpy sketches(&frames, &FrameLoop::sketchDrawn);
    const QSize whole = secondView().size();
    int moves = 0;
    const bool isShown = QTest::qWaitFor(
        [&] {
            ++moves;
            secondView().resize(whole - QSize(moves % 40, moves % 40));
            return !sketches.isEmpty();
        },
        limitMs);
    EXPECT_TRUE(isShown) << moves << " moves";
    EXPECT_EQ(frames.surface().picture().size(), secondView().size()) << "it is stretched";
}

} // namespace
} // namespace patina::tests::slow_views_test
