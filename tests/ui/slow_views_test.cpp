// SPDX-License-Identifier: GPL-3.0-or-later
// Views of the default scene that are so large that a software driver takes long for a frame.
#include <algorithm>
#include <vector>

#include <QImage>
#include <QSignalSpy>
#include <QTest>

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

} // namespace
} // namespace patina::tests::slow_views_test
