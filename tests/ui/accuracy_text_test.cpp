// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of accuracy writes and draws, without a window.
#include <cmath>

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QRegularExpression>

#include "accuracy/axis_ticks.h"
#include "accuracy/cost_list.h"
#include "accuracy/cost_plot.h"
#include "accuracy/cost_text.h"
#include "accuracy/plot_library.h"
#include "docks/elided_label.h"

namespace patina::tests::accuracy_text_test {
namespace {

TEST(CostText, Shares_AreWrittenWithoutExponents) {
    EXPECT_EQ(shareText(0.5e-6), "0.00005 %");
    EXPECT_EQ(shareText(1.2e-7), "0.000012 %");
    EXPECT_EQ(shareText(0.99e-8), "under 0.00001 %");
    EXPECT_EQ(shareText(0.031), "3.1 %");
    EXPECT_EQ(shareText(0.17), "17 %");
}

TEST(NumberText, MeasuredNumbers_AreWrittenAsTheFieldsWriteTheirs) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(digitsText(63457.0), "63457");
    EXPECT_EQ(digitsText(0.03171), "0.0317");
    EXPECT_EQ(likeText(0.0704, 1.0), "0.07");
    EXPECT_EQ(ratioText({0.953, 0.917, 0.989}), "0.953 ± 0.036");
    EXPECT_EQ(ratioText({1.0, 0.2, 9.0}), "1.00 ± ?");
    EXPECT_EQ(roundText(1000.0), "1000");
    EXPECT_EQ(roundText(2.5), "2.5");
    EXPECT_EQ(shortText(5e4), "50 k");
    EXPECT_EQ(shortText(2.5e6), "2.5 M");
    QLocale::setDefault(before);
}

TEST(ElidedLabel, WithoutRoom_EndsInDotsAndTellsAllInItsTooltip) {
    const QString text = "256 × 256 pixels, 31,447 of them shaded; errors against the same frame";
    ElidedLabel line;
    line.setElidedText(text);
    line.resize(1000, 20);
    EXPECT_EQ(line.shown(), text);
    line.resize(100, 20);
    EXPECT_TRUE(line.shown().endsWith("…")) << line.shown().toStdString();
    EXPECT_EQ(line.toolTip(), text);
    EXPECT_EQ(line.text(), text);
}

TEST(ElidedLabel, WithALimitOfLines_ElidesTheLastOne) {
    const QString text = "256 × 256 pixels, 31,447 of them shaded; errors against the same frame";
    ElidedLabel label;
    label.setMaxLines(2);
    label.setElidedText(text);
    label.resize(1000, 40);
    EXPECT_EQ(label.shown(), text);
    label.resize(150, 40);
    EXPECT_EQ(label.shown().count('\n'), 1) << label.shown().toStdString();
    EXPECT_TRUE(label.shown().startsWith("256 ×") && label.shown().endsWith("…"));
    EXPECT_EQ(label.toolTip(), text);
}

ChoiceCost costOf(double ratio, bool belowNoise) {
    ChoiceCost cost;
    cost.ratio = {ratio, 0.9 * ratio, 1.1 * ratio};
    cost.runs = 9;
    cost.nanosecondsPerPixel = 100.0 * ratio;
    cost.belowNoise = belowNoise;
    return cost;
}

TEST(CostText, TimesThatAreBounds_HaveTheirSign) {
    EXPECT_EQ(costRatioText(costOf(0.5, true), RatioBound::AtMost), "< 0.500");
    EXPECT_EQ(costRatioText(costOf(2.5, false), RatioBound::AtLeast), "> 2.50");
    EXPECT_EQ(costRatioText(costOf(1.0, true), RatioBound::Unknown), "–");
    EXPECT_EQ(perPixelText(costOf(0.5, true), true), "< 50.0");
    EXPECT_EQ(perPixelText(costOf(0.5, false), true), "50.0 ± 5.0");
    EXPECT_EQ(perPixelText(costOf(0.5, false), false), "50.0");
}

CostChart chartOfABound() {
    CostChart chart;
    chart.choices = {{Choice::Scope::Material,
                      "power",
                      "power",
                      "Power of the highlight",
                      "",
                      "Phong",
                      {{"exact", "Exact", ""}, {"fraction", "Schlick's fraction", ""}}}};
    chart.points.resize(2);
    chart.points[0].cost = costOf(1.0, false);
    chart.points[1].cost = costOf(0.5, true);
    chart.points[1].levels = {{"power", "fraction"}};
    chart.points[1].error.p99 = 0.01;
    return chart;
}

TEST(CostText, Notes_TellWhatWasLeftOutOnlyWhereSomethingWas) {
    CostChart chart = chartOfABound();
    EXPECT_EQ(notesText(chart), "");
    chart.leftOut = 27;
    EXPECT_EQ(notesText(chart), "27 combinations of choices were left out for want of time.");
}

TEST(CostList, TimesThatAreBounds_HaveTheirSignInEveryColumnOfTimes) {
    CostList list;
    list.setChart(chartOfABound(), {}, false);
    list.select(1);
    EXPECT_EQ(list.currentItem()->text(1), "< 50.0");
    EXPECT_EQ(list.currentItem()->text(3), "< 0.500");
}

TEST(CostList, SortedColumn_HasRoomForItsArrow) {
    CostList list;
    list.setChart(chartOfABound(), {}, false);
    for (int column = 1; column < list.columnCount(); ++column) {
        list.sortByColumn(column, Qt::DescendingOrder);
        EXPECT_GE(list.header()->sectionSize(column), list.header()->sectionSizeHint(column))
            << column;
    }
}

struct Mark {
    QColor edge;
    bool isFilled = false;
};

/// What is drawn before a row's name.
Mark markOf(const QTreeWidgetItem& row) {
    const QImage image = row.icon(0).pixmap(12, 12).toImage();
    const int middle = image.height() / 2;
    QColor edge(Qt::transparent);
    for (int x = 0; x < image.width() / 2 - 1; ++x) {
        const QColor here = image.pixelColor(x, middle);
        edge = here.alpha() > edge.alpha() ? here : edge;
    }
    return {edge, image.pixelColor(image.width() / 2, middle).alpha() > 0};
}

/// Allows for the rounding of what is half transparent.
bool isColour(const QColor& color, const QColor& wanted) {
    return std::abs(color.red() - wanted.red()) <= 4 &&
           std::abs(color.green() - wanted.green()) <= 4 &&
           std::abs(color.blue() - wanted.blue()) <= 4;
}

TEST(CostList, TiesOfTheFront_HaveACircleInItsColour) {
    CostChart chart = chartOfABound();
    chart.points[1].cost = costOf(0.99, false);
    chart.points.push_back(chart.points[1]);
    chart.points[2].levels = {{"power", "slower"}};
    chart.points[2].cost = costOf(2.0, false);
    CostList list;
    list.setChart(chart, {}, false);
    const auto row = [&list](int point) {
        list.select(point);
        return list.currentItem();
    };
    EXPECT_TRUE(row(1)->toolTip(0).contains("May be worth choosing, too"));
    EXPECT_FALSE(row(2)->toolTip(0).contains("May be worth choosing"));
    EXPECT_TRUE(markOf(*row(0)).isFilled);
    EXPECT_FALSE(markOf(*row(1)).isFilled);
    EXPECT_FALSE(markOf(*row(2)).isFilled);
    const QColor front = list.palette().color(QPalette::Highlight);
    EXPECT_TRUE(isColour(markOf(*row(0)).edge, front));
    EXPECT_TRUE(isColour(markOf(*row(1)).edge, front));
    EXPECT_FALSE(isColour(markOf(*row(2)).edge, front));
}

TEST(CostPlot, TimesThatAreBounds_SayItOnHover) {
    CostPlot plot;
    plot.setChart(chartOfABound(), {}, false);
    plot.select(1);
    const QString told = plot.accessibleDescription();
    EXPECT_TRUE(told.contains("At most 50.0 ns per pixel")) << told.toStdString();
}

TEST(FittingWay, WithoutRoom_CutsWhatWaysHaveInCommon) {
    const std::vector<SettingPart> parts{{"Power of the highlight", "Schlick's fraction"},
                                         {"Rough matte", "Fujii"}};
    const auto within = [&parts](qsizetype letters) {
        return fittingSetting(parts,
                              [letters](const QString& text) { return text.size() <= letters; });
    };
    EXPECT_EQ(within(100), "Power of the highlight: Schlick's fraction + Rough matte: Fujii");
    EXPECT_EQ(within(53), "Power of th…: Schlick's fraction + Rough matte: Fujii");
    EXPECT_EQ(within(50), "Power of…: Schlick's fraction + Rough mat…: Fujii");
    EXPECT_EQ(within(30), "Schlick's fraction + Fujii");
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

TEST(CostText, SettingName_SaysWhatIsChosenOfWhat) {
    CostChart chart;
    chart.choices = {{Choice::Scope::Picture,
                      "picture.scale",
                      "picture.scale",
                      "Render scale",
                      "",
                      "Picture",
                      {{"full", "Full size", ""}, {"half", "Half", "1 of 4."}}}};
    CostPoint point;
    EXPECT_EQ(settingName(point, chart), "Exact");
    point.levels = {{"picture.scale", "half"}};
    EXPECT_EQ(settingName(point, chart), "Render scale: Half");
    EXPECT_EQ(settingDescription(point, chart), "Render scale: Half. 1 of 4.");
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

} // namespace
} // namespace patina::tests::accuracy_text_test
