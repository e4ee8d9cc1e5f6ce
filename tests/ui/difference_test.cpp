// SPDX-License-Identifier: GPL-3.0-or-later
// C beside A and B: how far they are apart.
#include <algorithm>
#include <utility>

#include "document/compare_edits.h"
#include "ui/accuracy_fixture.h"
#include "viewport/difference_view.h"

namespace patina::tests::difference_test {
namespace {

class Difference : public MeasuredPanel {
  protected:
    /// Views so tall that half their width is too narrow for the object.
    Difference() {
        window().resize(1000, 680);
        newFrames();
    }

    /// The exact way in A and one that is off by a tenth in B, without measuring that.
    void compareWithFar() {
        window().comparison().setComparing(true);
        Material chosen = *document().material(Side::B);
        chosen.accuracy["work"] = "far";
        setSecondMaterial(document(), chosen);
        window().views().setDifferenceWanted(true);
        ASSERT_TRUE(waitForView());
    }

    bool waitForView() {
        QTest::qWait(20);
        return QTest::qWaitFor([this] { return view().isUpToDate(); }, waitMs);
    }

    DifferenceView& view() { return *window().views().difference(); }

    static int brightest(const QImage& picture) {
        int largest = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                largest = std::max(largest, qGray(picture.pixel(x, y)));
            }
        }
        return largest;
    }

    /// Sums over all pixels.
    static std::pair<int, int> redAndBlue(const QImage& picture) {
        std::pair<int, int> sums;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                sums.first += qRed(picture.pixel(x, y));
                sums.second += qBlue(picture.pixel(x, y));
            }
        }
        return sums;
    }
};

TEST_F(Difference, KnownError_IsShownAsThat) {
    compareWithFar();
    ASSERT_NE(view().difference(), nullptr);
    EXPECT_NEAR(std::ranges::max(view().difference()->relative), float(farError), 1e-4f);
}

TEST_F(Difference, Gain_MakesItBrighter) {
    compareWithFar();
    view().setGain(1.0);
    const int plain = brightest(view().picture());
    view().setGain(4.0);
    EXPECT_GT(brightest(view().picture()), plain);
    EXPECT_GT(plain, 0);
}

TEST_F(Difference, SameMaterials_AreBlackAtTheGreatestGain) {
    window().comparison().setComparing(true);
    window().views().setDifferenceWanted(true);
    ASSERT_TRUE(waitForView());
    view().setGain(DifferenceView::maxGain);
    EXPECT_EQ(brightest(view().picture()), 0);
}

TEST_F(Difference, ChangedMaterial_IsFollowed) {
    compareWithFar();
    setSecondMaterial(document(), *document().material(Side::A));
    ASSERT_TRUE(waitForView());
    EXPECT_EQ(std::ranges::max(view().difference()->relative), 0.0f);
}

TEST_F(Difference, ErrorMode_HasColours) {
    compareWithFar();
    view().setMode(DifferenceView::Mode::Error);
    const auto [red, blue] = redAndBlue(view().picture());
    EXPECT_GT(red, 2 * blue); // a tenth is orange
}

TEST_F(Difference, EndOfComparing_HidesIt) {
    compareWithFar();
    EXPECT_TRUE(view().isVisible());
    window().comparison().setComparing(false);
    EXPECT_FALSE(view().isVisible());
}

TEST_F(Difference, NotWantedAnyMore_GivesTheCameraBack) {
    window().comparison().setComparing(true);
    settle(); // the views have their sizes
    const Camera before = camera();
    window().views().setDifferenceWanted(true);
    settle();
    EXPECT_GT(camera().distance, before.distance);
    window().views().setDifferenceWanted(false);
    settle();
    EXPECT_EQ(camera(), before);
}

TEST_F(Difference, ComparedPointThatIsUndone_GivesTheCameraBack) {
    const Camera before = camera();
    dock().compare(pointOf("near"));
    EXPECT_GT(camera().distance, before.distance);
    EXPECT_EQ(secondView().camera(), camera());
    document().undoStack().undo();
    EXPECT_EQ(camera(), before);
    document().undoStack().redo();
    EXPECT_GT(camera().distance, before.distance);
    window().comparison().setComparing(false);
    EXPECT_EQ(camera(), before);
}

TEST_F(Difference, ComparedPoint_IsNoOtherView) {
    dock().compare(pointOf("near"));
    settle();
    EXPECT_FALSE(state().contains("another view")) << state().toStdString();
    window().comparison().setComparing(false);
    settle();
    EXPECT_FALSE(state().contains("another view")) << state().toStdString();
}

TEST_F(Difference, CameraMovedWhileComparing_StaysThereAfterwards) {
    window().comparison().setComparing(true);
    window().views().setDifferenceWanted(true);
    Camera wished = camera();
    wished.yaw += 30.0;
    Q_EMIT window().views().first().cameraWished(wished);
    EXPECT_EQ(camera().yaw, wished.yaw);
    EXPECT_NEAR(camera().distance, wished.distance, 1e-12 * wished.distance);
    window().comparison().setComparing(false);
    EXPECT_EQ(camera(), document().scene().camera);
    EXPECT_EQ(camera().yaw, wished.yaw);
}

TEST_F(Difference, ComparedPoint_ShowsItBesideTheExactWay) {
    dock().compare(pointOf("near"));
    ASSERT_TRUE(window().views().difference() != nullptr && waitForView());
    EXPECT_NEAR(std::ranges::max(view().difference()->relative), float(nearError), 1e-5f);
}

} // namespace
} // namespace patina::tests::difference_test
