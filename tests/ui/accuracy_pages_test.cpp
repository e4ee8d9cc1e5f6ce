// SPDX-License-Identifier: GPL-3.0-or-later
// The pages beside the chart: all models, and how the time grows.
#include <cmath>

#include <QHeaderView>
#include <QRegularExpression>

#include "accuracy/axis_ticks.h"
#include "accuracy/cost_text.h"
#include "accuracy/growth_plot.h"
#include "accuracy/long_line.h"
#include "accuracy/model_list.h"
#include "accuracy/models_page.h"
#include "accuracy/scaling_page.h"
#include "ui/accuracy_fixture.h"

namespace patina::tests {
namespace {

TEST(CostText, Shares_AreWrittenWithoutExponents) {
    EXPECT_EQ(shareText(0.5e-6), "0.00005 %");
    EXPECT_EQ(shareText(1.2e-7), "0.000012 %");
    EXPECT_EQ(shareText(0.99e-8), "under 0.00001 %");
    EXPECT_EQ(shareText(0.031), "3.1 %");
    EXPECT_EQ(shareText(0.17), "17 %");
}

TEST(NumberText, MeasuredNumbers_AreWrittenWithoutExponents) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    EXPECT_EQ(digitsText(63457.0), "63,457");
    EXPECT_EQ(digitsText(0.03171), "0.0317");
    EXPECT_EQ(likeText(0.0704, 1.0), "0.07");
    EXPECT_EQ(ratioText({0.953, 0.917, 0.989}), "0.953 ± 0.036");
    EXPECT_EQ(ratioText({1.0, 0.2, 9.0}), "1.00 ± ?");
    EXPECT_EQ(roundText(1000.0), "1,000");
    EXPECT_EQ(roundText(2.5), "2.5");
    EXPECT_EQ(shortText(5e4), "50 k");
    EXPECT_EQ(shortText(2.5e6), "2.5 M");
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(roundText(2.5), "2,5");
    EXPECT_EQ(digitsText(9346.0), "9.346");
    QLocale::setDefault(before);
}

TEST(LongLine, WithoutRoom_EndsInDotsAndTellsAllInItsTooltip) {
    const QString text = "256 × 256 pixels, 31,447 of them shaded; errors against the same frame";
    LongLine line;
    line.tell(text);
    line.resize(1000, 20);
    EXPECT_EQ(line.shown(), text);
    line.resize(100, 20);
    EXPECT_TRUE(line.shown().endsWith("…")) << line.shown().toStdString();
    EXPECT_EQ(line.toolTip(), text);
    EXPECT_EQ(line.text(), text);
}

/// How far to the left a chart's lines go in a file.
double leftmostOf(const MedianInterval& ratio) {
    CostChart chart;
    chart.points.resize(2);
    for (CostPoint& point : chart.points) {
        point.cost.nanosecondsPerPixel = 100.0;
    }
    chart.points[1].levels = {{"a", "b"}};
    chart.points[1].error.p99 = 0.01;
    chart.points[1].cost.ratio = ratio;
    CostPlot plot;
    plot.setChart(chart, {}, false);
    const QString svg = QString::fromUtf8(plot.svg());
    static const QRegularExpression points("<polyline[^>]* points=\"([^\"]*)\"");
    double leftmost = HUGE_VAL;
    for (const QRegularExpressionMatch& line : points.globalMatch(svg)) {
        for (const QString& point : line.captured(1).split(' ', Qt::SkipEmptyParts)) {
            leftmost = std::min(leftmost, point.section(',', 0, 0).toDouble());
        }
    }
    return leftmost;
}

TEST(CostPlot, WideIntervals_EndWithTheChartInAFileToo) {
    EXPECT_GT(leftmostOf({1.0, 0.99, 1.01}), 10.0);
    EXPECT_EQ(leftmostOf({1.0, 0.001, 50.0}), leftmostOf({1.0, 0.5, 2.0}));
}

TEST(CostText, WayName_SaysWhatIsChosenOfWhat) {
    CostChart chart;
    chart.choices = {{Choice::Scope::Picture, "picture.scale", "picture.scale", "Render scale", "",
                      "Picture", {{"full", "Full size", ""}, {"half", "Half", "1 of 4."}}}};
    CostPoint point;
    EXPECT_EQ(wayName(point, chart), "Exact");
    point.levels = {{"picture.scale", "half"}};
    EXPECT_EQ(wayName(point, chart), "Render scale: Half");
    EXPECT_EQ(wayDescription(point, chart), "Render scale: Half. 1 of 4.");
}

/// What a plot of some size writes beside a log axis.
std::vector<QString> marksOf(int width, double from, double to) {
    QCustomPlot plot;
    plot.setViewport(QRect(0, 0, width, 200));
    plot.xAxis->setScaleType(QCPAxis::stLogarithmic);
    plot.xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new AxisTicks(*plot.xAxis, shortText)));
    plot.xAxis->setRange(from, to);
    plot.replot();
    const QVector<QString> labels = plot.xAxis->tickVectorLabels();
    return {labels.begin(), labels.end()};
}

TEST(AxisTicks, WhereThereIsRoom_AreAtOneTwoAndFive) {
    EXPECT_EQ(marksOf(800, 900.0, 110000.0),
              (std::vector<QString>{"1 k", "2 k", "5 k", "10 k", "20 k", "50 k", "100 k"}));
}

TEST(AxisTicks, WhereThereIsLittle_KeepTheirLabelsApart) {
    EXPECT_EQ(marksOf(240, 900.0, 110000.0), (std::vector<QString>{"1 k", "10 k", "100 k"}));
}

TEST(AxisTicks, OfAShortAxis_AreEven) {
    EXPECT_EQ(marksOf(500, 390.0, 810.0),
              (std::vector<QString>{"400", "500", "600", "700", "800"}));
}

class ModelsPanel : public AccuracyPanel {
  protected:
    ModelsPanel() { pages().setCurrentWidget(&page()); }

    ModelsPage& page() { return *pages().findChild<ModelsPage*>(); }
    ModelList& models() { return *page().findChild<ModelList*>(); }

    /// The first models only: they take long to compile.
    void measureSome() {
        CostSweep::Options options;
        options.size = {16, 16};
        options.pairs.fewest = 3;
        options.pairs.most = 3;
        page().measure(options);
        ASSERT_TRUE(QTest::qWaitFor([this] { return page().costs().size() >= 2; }, waitMs));
        for (QToolButton* button : page().findChildren<QToolButton*>()) {
            if (button->text() == "Stop") {
                button->click();
            }
        }
        ASSERT_TRUE(QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs));
    }
};

TEST_F(ModelsPanel, Stopped_KeepsWhatIsMeasured) {
    measureSome();
    EXPECT_TRUE(page().state().startsWith("Stopped")) << page().state().toStdString();
    EXPECT_EQ(models().topLevelItemCount(), static_cast<int>(page().costs().size()));
}

TEST_F(ModelsPanel, OtherScene_PutsItOutOfDate) {
    measureSome();
    document().setModel(Side::A, page().costs().front().model);
    settle();
    EXPECT_FALSE(page().isStale()); // every model was measured with its defaults
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(page().isStale());
}

TEST_F(ModelsPanel, LightLost_IsWrittenAsTheLanguageHasIt) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    const auto textOf = [this](double loss) {
        models().setCosts({{"matte", "Matte", {}, std::nullopt, loss}}, false);
        return models().topLevelItem(0)->text(models().columnCount() - 1);
    };
    const QString text = textOf(0.255);
    const QString nothing = textOf(-1e-7);
    QLocale::setDefault(before);
    EXPECT_EQ(text, "25,5 %");
    EXPECT_EQ(nothing, "0,0 %");
}

TEST_F(ModelsPanel, SceneThatIsBack_HasItsNumbersAgain) {
    measureSome();
    const std::string first = page().costs().front().model;
    document().setFog("exponential");
    settle();
    measureSome();
    EXPECT_FALSE(page().isStale());
    document().undoStack().undo();
    settle();
    EXPECT_FALSE(page().isStale()) << first;
    EXPECT_EQ(models().topLevelItemCount(), static_cast<int>(page().costs().size()));
}

TEST_F(ModelsPanel, Columns_FitBesideEachOtherInADockOfUsualWidth) {
    constexpr int dockOf1600 = 846; // pixels between the docks at the sides, less a scroll bar
    EXPECT_LE(models().header()->length(), dockOf1600);
}

TEST_F(ModelsPanel, Enter_GivesTheObjectThatModel) {
    measureSome();
    models().setCurrentItem(models().topLevelItem(1));
    const QString model = models().currentItem()->data(0, Qt::UserRole).toString();
    QTest::keyClick(&models(), Qt::Key_Return);
    EXPECT_EQ(document().material(Side::A)->model.id, model.toStdString());
}

TEST_F(ModelsPanel, ExportedTable_HasALineForEveryModel) {
    measureSome();
    const QString file = QString::fromStdString((home("ranking") += ".csv").string());
    page().exportTo(file);
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    EXPECT_EQ(written.readAll().trimmed().split('\n').size(), 1 + models().topLevelItemCount());
}

class ScalingPanel : public AccuracyPanel {
  protected:
    ScalingPanel() {
        document().setModel(Side::A, "lambert");
        pages().setCurrentWidget(&page());
    }

    ScalingPage& page() { return *pages().findChild<ScalingPage*>(); }

    /// Of the menu View > Look.
    QAction& lookAction(const QString& text) {
        const QList<QAction*> all = window().findChildren<QAction*>();
        return **std::ranges::find(all, text, &QAction::text);
    }

    QToolButton& startButton() {
        const QList<QToolButton*> all = page().findChildren<QToolButton*>();
        return **std::ranges::find(all, "Measure", &QToolButton::text);
    }

    bool measureSmall() {
        ScalingSweep::Options options;
        options.edges = {16, 32, 64};
        options.lights = {1, 2, 4};
        options.objects = {1, 2, 4};
        options.edge = 32;
        options.rounds = 2;
        page().measure(options);
        return QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs);
    }
};

TEST_F(ScalingPanel, Measured_HasALawForEachAxis) {
    ASSERT_TRUE(measureSmall());
    ASSERT_EQ(page().curves().size(), 3u) << page().state().toStdString();
    for (GrowthPlot* plot : page().findChildren<GrowthPlot*>()) {
        EXPECT_FALSE(plot->law().isEmpty());
    }
}

TEST_F(ScalingPanel, Laws_AreWrittenAsTheLanguageHasThem) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    ScalingCurve curve{ScalingCurve::Axis::Lights,
                       {{1, {2.5, 2.5, 2.5}}, {4, {4, 4, 4}}, {64, {34, 34, 34}}},
                       std::nullopt};
    curve.law = growthLaw(curve.samples);
    GrowthPlot plot(curve.axis);
    plot.setCurve(curve, false);
    QLocale::setDefault(before);
    EXPECT_EQ(plot.law(), "linear: 2 ms + 0,5 ms per light, R² 1,000");
}

TEST_F(ScalingPanel, WhileAnotherPageMeasures_WaitsAndSaysWhy) {
    document().setModel(Side::A, "burning");
    pages().setCurrentWidget(&dock());
    settle();
    start();
    ASSERT_TRUE(dock().isMeasuring());
    pages().setCurrentWidget(&page());
    EXPECT_FALSE(startButton().isEnabled());
    EXPECT_TRUE(startButton().toolTip().contains("This Material"));
    EXPECT_TRUE(page().state().contains("This Material")) << page().state().toStdString();
    page().measure({});
    EXPECT_FALSE(page().isMeasuring());
    ASSERT_TRUE(waitForEnd());
    EXPECT_TRUE(startButton().isEnabled());
    EXPECT_EQ(page().state(), "Nothing is measured yet.");
}

TEST_F(ScalingPanel, OtherLook_PaintsThePlotsInIt) {
    const auto paper = [this] {
        return page().findChild<GrowthPlot*>()->grab().toImage().pixelColor(2, 2).lightness();
    };
    lookAction("&Dark").trigger();
    settle();
    EXPECT_LT(paper(), 100);
    lookAction("&Light").trigger();
    settle();
    EXPECT_GT(paper(), 200);
}

TEST_F(ScalingPanel, SceneThatIsBack_HasItsNumbersAgain) {
    ASSERT_TRUE(measureSmall());
    const std::vector<ScalingCurve> first = page().curves();
    document().setFog("exponential");
    settle();
    ASSERT_TRUE(measureSmall());
    EXPECT_FALSE(page().isStale());
    EXPECT_FALSE(page().curves() == first);
    document().undoStack().undo();
    settle();
    EXPECT_FALSE(page().isStale());
    EXPECT_TRUE(page().curves() == first);
}

TEST_F(ScalingPanel, SavedDocument_KeepsItsNumbers) {
    ASSERT_TRUE(measureSmall());
    ASSERT_TRUE(document().saveScene(home("saved.patina-scene.json")));
    settle();
    EXPECT_FALSE(page().isStale());
    EXPECT_EQ(page().curves().size(), 3u);
}

TEST_F(ScalingPanel, OtherDocument_HasNoneOfItsNumbers) {
    ASSERT_TRUE(document().saveScene(home("one.patina-scene.json")));
    ASSERT_TRUE(measureSmall());
    document().startFrom(Scene(document().scene()));
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(page().curves().empty());
    ASSERT_TRUE(document().openScene(home("one.patina-scene.json")));
    settle();
    EXPECT_EQ(page().curves().size(), 3u);
}

TEST_F(ScalingPanel, ChangedScene_PutsItOutOfDate) {
    ASSERT_TRUE(measureSmall());
    EXPECT_FALSE(page().isStale());
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(page().isStale());
}

} // namespace
} // namespace patina::tests
