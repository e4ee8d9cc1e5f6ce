// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "ui/window_fixture.h"
#include "viewport/views_capture.h"

namespace patina::tests::views_capture_test {
namespace {

class ViewsCaptured : public WindowFixture {
  protected:
    Image taken(bool display) {
        Image image;
        bool isTaken = false;
        ViewsCapture capture(window().views());
        capture.start(display, [&](Image picture) {
            image = std::move(picture);
            isTaken = true;
        });
        EXPECT_TRUE(QTest::qWaitFor([&] { return isTaken; }, 20000));
        capture.cancel(); // what came later would have nowhere to go
        return image;
    }

    /// A and B, which differ.
    void compare() {
        window().comparison().setComparing(true);
        window().files().applyPreset(QString::fromStdString(otherPreset(document()).string()),
                                     Side::B);
        settle();
        newFrames();
        ASSERT_TRUE(QTest::qWaitFor([this] { return secondView().frames().isUpToDate(); }, 20000));
    }

    /// A part of a picture.
    static Image part(const Image& image, int left, int top, const QSize& size) {
        Image part{size.width(), size.height(), 3, {}};
        for (int y = top; y < top + size.height(); ++y) {
            for (int x = left; x < left + size.width(); ++x) {
                const std::size_t place = std::size_t(y) * std::size_t(image.width) + x;
                const float* pixel = image.pixels.data() + place * std::size_t(image.channels);
                part.pixels.insert(part.pixels.end(), pixel, pixel + 3);
            }
        }
        return part;
    }
};

TEST_F(ViewsCaptured, OneView_IsItsPicture) {
    EXPECT_EQ(taken(true), view().capture().picture(true));
}

TEST_F(ViewsCaptured, WhileComparing_AreASideBySideBelowTheirTitles) {
    compare();
    const Image both = taken(true);
    const QSize a = view().size();
    const QSize b = secondView().size();
    EXPECT_EQ(both.width, a.width() + b.width());
    ASSERT_GT(both.height, a.height());
    const int top = both.height - a.height();
    EXPECT_EQ(part(both, 0, top, a), asImage(view().grabPicture()));
    EXPECT_EQ(part(both, a.width(), top, b), asImage(secondView().grabPicture()));
    EXPECT_NE(part(both, 0, top, a), part(both, a.width(), top, a));
}

TEST_F(ViewsCaptured, LinearFloatsWhileComparing_HaveNoTitles) {
    compare();
    const Image both = taken(false);
    EXPECT_EQ(both.width, view().width() + secondView().width());
    EXPECT_EQ(both.height, view().height());
}

TEST(PicturesInARow, OfUnequalHeights_AreAsHighAsTheHighest) {
    const Image low{1, 1, 3, {0.1f, 0.2f, 0.3f}};
    const Image high{1, 2, 4, {0.4f, 0.5f, 0.6f, 1.0f, 0.7f, 0.8f, 0.9f, 1.0f}};
    const Image row = inARow({low, high});
    EXPECT_EQ(
        row,
        (Image{2, 2, 3, {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.0f, 0.0f, 0.0f, 0.7f, 0.8f, 0.9f}}));
}

} // namespace
} // namespace patina::tests::views_capture_test
