// SPDX-License-Identifier: GPL-3.0-or-later
// The panel that counts how bright the pixels of the view are.
#include <cmath>
#include <functional>

#include <QComboBox>
#include <QLabel>
#include <QTest>

#include "docks/histogram_dock.h"
#include "docks/histogram_plot.h"
#include "document/own_view.h"
#include "ui/fixtures.h"
#include "ui/window_fixture.h"

namespace patina::tests::histogram_test {
namespace {

using H = PictureHistogram;

class HistogramPanel : public WindowFixture {
  protected:
    HistogramPanel() {
        window().dock("histogram")->show();
        window().dock("histogram")->raise();
        EXPECT_TRUE(waitFor([this] { return plot().histogram().has_value(); }));
        settle();
    }

    static bool waitFor(const std::function<bool()>& isThere) {
        return QTest::qWaitFor(isThere, 30000);
    }

    HistogramDock& panel() { return *window().dock("histogram")->findChild<HistogramDock*>(); }
    HistogramPlot& plot() { return *panel().findChild<HistogramPlot*>(); }
    QString text() { return panel().findChild<QLabel*>("histogramText")->text(); }

    void setExposure(double stops) {
        document().setValue(pathOf(settings::scene), exposureSetting, stops);
    }
};

TEST_F(HistogramPanel, CountsThePixelsThatTheViewShows_WithoutDrawingThem) {
    setExposure(0.5);
    const int drawn = newFrames();
    settle();
    EXPECT_EQ(newFrames(), 0) << drawn;
    const QImage shown = view().grabPicture().convertToFormat(QImage::Format_RGB32);
    H::Counts green(256, 0);
    for (int y = 0; y < shown.height(); ++y) {
        for (int x = 0; x < shown.width(); ++x) {
            ++green[static_cast<std::size_t>(qGreen(shown.pixel(x, y)))];
        }
    }
    EXPECT_EQ(plot().histogram()->counts[H::Green], green);
}

TEST_F(HistogramPanel, MoreExposure_ClipsMoreAndSaysSo) {
    const double before = plot().histogram()->clippedAny;
    const QString said = text();
    setExposure(6.0);
    EXPECT_TRUE(waitFor([&] { return plot().histogram()->clippedAny > before + 0.05; }));
    EXPECT_NE(text(), said);
    EXPECT_TRUE(text().contains("clipped"));
}

TEST_F(HistogramPanel, OfLight_MovesByTheExposure) {
    panel().findChild<QComboBox*>()->setCurrentIndex(1);
    ASSERT_TRUE(waitFor([this] { return text().startsWith("Half"); }));
    const auto median = [this] { return brightnessOf(*plot().histogram()).median; };
    const double before = median();
    setExposure(2.0);
    EXPECT_TRUE(waitFor([&] { return std::abs(median() - before - 2.0) < 1.5 / binsPerStop; }));
    EXPECT_TRUE(plot().textAt(plot().rect().center()).contains("stops from white"));
    EXPECT_TRUE(plot().textAt({-1, -1}).isEmpty());
}

} // namespace
} // namespace patina::tests::histogram_test
