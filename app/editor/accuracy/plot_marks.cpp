// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/plot_marks.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QPainterPath>

#include "accuracy/axis_ticks.h"
#include "accuracy/plot_colors.h"
#include "accuracy/plot_library.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

/// Is the shortest time on the log axis, nanoseconds per pixel; no pixel is shaded so fast.
constexpr double minTime = 1e-3;

/// Is the smallest error on the log axis; less is the rounding of floats.
constexpr double minError = 1e-6;

constexpr double timeMargin = 1.12;
constexpr double errorMargin = 2.5;
constexpr double minErrorRange = 1e3; ///< ratio of the ends of the error axis, at least
/// Is the ratio to a point's time; a longer interval does not widen the chart.
constexpr double longestBar = 2.0;
constexpr double pointSize = 7.0;
constexpr double ringSize = 13.0;

QCPGraph* makeGraph(QCustomPlot& plot, QCPGraph::LineStyle line) {
    QCPGraph* graph = plot.addGraph();
    graph->setLineStyle(line);
    graph->setAdaptiveSampling(false);
    graph->setSelectable(QCP::stNone);
    return graph;
}

PlotMarks::Dots makeDots(QCustomPlot& plot) {
    return {makeGraph(plot, QCPGraph::lsNone), makeGraph(plot, QCPGraph::lsNone)};
}

double shownTime(const CostPoint& point) {
    return std::max(point.cost.nanosecondsPerPixel, minTime);
}

/// Returns nanoseconds per pixel with the interval of the ratio to the exact time; for a bound the
/// interval begins below the chart.
MedianInterval timeInterval(const CostPoint& point) {
    const MedianInterval& ratio = point.cost.ratio;
    const double time = shownTime(point);
    if (point.cost.belowNoise) {
        return {time, 0.5 * minTime, time};
    }
    const double perRatio = ratio.median > 0.0 ? time / ratio.median : 0.0;
    return {time, std::clamp(ratio.lower * perRatio, 0.5 * minTime, time),
            std::max(ratio.upper * perRatio, time)};
}

/// Returns the mark of a bound, an arrow towards shorter times.
QPainterPath arrowToLess() {
    QPainterPath arrow;
    arrow.moveTo(-4.0, 0.0);
    arrow.lineTo(2.5, -3.4);
    arrow.lineTo(2.5, 3.4);
    arrow.closeSubpath();
    return arrow;
}

/// Returns the error that counts as exact: that of the exact frame, which is the rounding of
/// floats.
double floorOf(const CostChart& chart) {
    const double exact = chart.points.empty() ? 0.0 : errorOf(chart.points.front());
    return std::max(minError, exact);
}

double shownError(const CostPoint& point, const CostChart& chart) {
    return std::max(errorOf(point), floorOf(chart));
}

QPointF shownAt(const CostPoint& point, const CostChart& chart) {
    return {shownTime(point), shownError(point, chart)};
}

} // namespace

PlotMarks::PlotMarks(QCustomPlot& plot)
    : plot_(plot), all_(makeGraph(plot, QCPGraph::lsNone)),
      intervals_(new QCPErrorBars(plot.xAxis, plot.yAxis)),
      line_(makeGraph(plot, QCPGraph::lsLine)), beaten_(makeDots(plot)), ties_(makeDots(plot)),
      front_(makeDots(plot)), current_(makeGraph(plot, QCPGraph::lsNone)),
      selected_(makeGraph(plot, QCPGraph::lsNone)), errors_(new AxisTicks(*plot.yAxis, shareText)) {
    intervals_->setErrorType(QCPErrorBars::etKeyError);
    intervals_->setDataPlottable(all_);
    intervals_->setWhiskerWidth(5.0);
    intervals_->setSymbolGap(pointSize);
    intervals_->setSelectable(QCP::stNone);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setScaleType(QCPAxis::stLogarithmic);
        axis->setSubTicks(false);
    }
    plot.xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new AxisTicks(*plot.xAxis, roundText)));
    plot.yAxis->setTicker(errors_);
    plot.yAxis->setLabel(QCoreApplication::translate("PlotMarks", "error"));
}

void PlotMarks::Dots::colour(const QColor& edge, const QColor& inside) const {
    const QPen pen(edge, 1.3);
    known->setScatterStyle({QCPScatterStyle::ssCircle, pen, QBrush(inside), pointSize});
    bounds->setScatterStyle({arrowToLess(), pen, QBrush(inside), pointSize});
}

void PlotMarks::draw(const Content& content, const QPalette& palette) {
    scaleAxes(content.chart);
    drawPoints(content);
    colour(palette, content.stale);
    plot_.replot(QCustomPlot::rpQueuedReplot);
}

void PlotMarks::drawPoints(const Content& content) {
    for (QCPGraph* graph : {all_, line_, beaten_.known, beaten_.bounds, ties_.known, ties_.bounds,
                            front_.known, front_.bounds, current_, selected_}) {
        graph->data()->clear();
    }
    const std::vector<CostPoint>& points = content.chart.points;
    const std::vector<Standing> standing = standings(points);
    drawLine(content.chart, costFront(points));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const QPointF place = shownAt(points[i], content.chart);
        const Dots& dots = standing[i] == Standing::OnFront ? front_
                           : standing[i] == Standing::Tie   ? ties_
                                                            : beaten_;
        (points[i].cost.belowNoise ? dots.bounds : dots.known)->addData(place.x(), place.y());
        if (static_cast<int>(i) == content.current) {
            current_->addData(place.x(), place.y());
        }
        if (static_cast<int>(i) == content.selected) {
            selected_->addData(place.x(), place.y());
        }
    }
    drawIntervals(content.chart);
}

/// Skips points that tie in error: they are on the front as well, and would put steps in the line.
void PlotMarks::drawLine(const CostChart& chart, const std::vector<std::size_t>& front) {
    double bestYet = HUGE_VAL;
    for (const std::size_t i : front) {
        const QPointF place = shownAt(chart.points[i], chart);
        if (place.y() < bestYet) {
            bestYet = place.y();
            line_->addData(place.x(), place.y());
        }
    }
}

/// Adds points in the order of their times, in which the graph keeps them, since intervals are
/// matched by index. Clips the intervals to the chart, since SVG files are not clipped.
void PlotMarks::drawIntervals(const CostChart& chart) {
    std::vector<CostPoint> points = chart.points;
    std::ranges::stable_sort(points, {}, [](const CostPoint& point) { return shownTime(point); });
    const QCPRange chartTimes = plot_.xAxis->range();
    QVector<double> below;
    QVector<double> above;
    for (const CostPoint& point : points) {
        const QPointF place = shownAt(point, chart);
        const MedianInterval interval = timeInterval(point);
        all_->addData(place.x(), place.y());
        below << place.x() - std::max(interval.lower, chartTimes.lower);
        above << std::min(interval.upper, chartTimes.upper) - place.x();
    }
    intervals_->setData(below, above);
}

void PlotMarks::scaleAxes(const CostChart& chart) {
    const double floor = floorOf(chart);
    double from = HUGE_VAL;
    double to = 0.0;
    double worst = minErrorRange * floor;
    for (const CostPoint& point : chart.points) {
        const MedianInterval interval = timeInterval(point);
        const double time = shownTime(point);
        from = std::min(from, std::max(interval.lower, time / longestBar));
        to = std::max(to, std::min(interval.upper, time * longestBar));
        worst = std::max(worst, shownError(point, chart));
    }
    from = to > 0.0 ? from / timeMargin : 1.0;
    to = to > 0.0 ? to * timeMargin : 100.0;
    plot_.xAxis->setLabel(
        chart.predictedFor.empty()
            ? QCoreApplication::translate("PlotMarks", "ns per pixel")
            : QCoreApplication::translate("PlotMarks", "ns per pixel, predicted for %1")
                  .arg(asText(chart.predictedFor)));
    plot_.xAxis->setRange(from, to);
    plot_.yAxis->setRange(floor / errorMargin, worst * errorMargin);
    errors_->begin(floor, QCoreApplication::translate("PlotMarks", "exact"));
}

void PlotMarks::colour(const QPalette& palette, bool stale) {
    const QColor base = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor faint = palette.color(QPalette::PlaceholderText);
    const QColor accent = stale ? faint : palette.color(QPalette::Highlight).lighter(115);
    colourPlot(plot_, palette, stale);
    intervals_->setPen(QPen(mixed(base, text, 0.45), 1.0));
    line_->setPen(QPen(mixed(base, accent, 0.7), 1.5));
    beaten_.colour(faint, base);
    ties_.colour(accent, base);
    front_.colour(accent, accent);
    current_->setScatterStyle(
        {QCPScatterStyle::ssCircle, QPen(text, 1.5), QBrush(Qt::NoBrush), ringSize});
    selected_->setScatterStyle(
        {QCPScatterStyle::ssSquare, QPen(accent, 1.5), QBrush(Qt::NoBrush), ringSize + 4.0});
}

QPointF PlotMarks::placeOf(const CostPoint& point, const CostChart& chart) const {
    const QPointF place = shownAt(point, chart);
    return {plot_.xAxis->coordToPixel(place.x()), plot_.yAxis->coordToPixel(place.y())};
}

} // namespace patina
