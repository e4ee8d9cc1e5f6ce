// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cost_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/plot_labels.h"

namespace patina {
namespace {

using Shapes = std::vector<PlotShape>;

using plot_colors::grid;
using plot_colors::ink;

constexpr glm::dvec3 onFront(1.0, 0.72, 0.3);
constexpr glm::dvec3 beaten(0.5, 0.6, 0.7);

constexpr double marginLeft = 90.0;
constexpr double marginRight = 150.0;
constexpr double marginTop = 40.0;
constexpr double marginBottom = 50.0;
constexpr double arrowLength = 22.0;
constexpr double arrowHead = 4.0;

/// Errors below this are the rounding of floats.
constexpr double minError = 1e-7;

/// Maps exponents to pixels along a logarithmic axis.
struct Axis {
    double low = 1.0; ///< exponents at its ends, of base two or ten
    double high = 2.0;
    double from = 0.0; ///< pixels; `from` belongs to `low`, and `to` to `high`
    double to = 1.0;

    double place(double exponent) const {
        return from + (to - from) * (exponent - low) / (high - low);
    }
};

struct Axes {
    Axis time;  ///< has exponents of base two
    Axis error; ///< has exponents of base ten

    glm::dvec2 place(double ratio, double error_) const {
        return {time.place(std::log2(ratio)), error.place(std::log10(std::max(error_, minError)))};
    }
};

Axes axesOf(const CostChart& chart, glm::ivec2 size) {
    double lowest = 0.0;
    double highest = 0.0;
    double worst = std::log10(minError) + 1.0;
    for (const CostPoint& point : chart.points) {
        lowest = std::min(lowest, std::log2(std::max(point.cost.ratio.lower, 1e-3)));
        highest = std::max(highest, std::log2(std::max(point.cost.ratio.upper, 1e-3)));
        worst = std::max(worst, std::log10(std::max(errorOf(point), minError)));
    }
    return {{std::floor(lowest - 0.2), std::ceil(highest + 0.2), marginLeft, size.x - marginRight},
            {std::log10(minError) - 0.3, std::ceil(worst + 0.1), size.y - marginBottom, marginTop}};
}

/// Returns a power of ten as a percentage: "0.01 %" of -4.
std::string percentText(int power) {
    constexpr int ofHundred = 2;
    return fmt::format("{:.{}f} %", std::pow(10.0, power + ofHundred),
                       std::max(-power - ofHundred, 0));
}

void addGrid(Shapes& shapes, const CostChart& chart, const Axes& axes) {
    for (double e = axes.time.low; e <= axes.time.high; ++e) {
        const double x = axes.time.place(e);
        shapes.push_back(
            {PlotShape::Kind::Line, {x, axes.error.from}, {x, axes.error.to}, grid, {}});
        shapes.push_back({PlotShape::Kind::Text,
                          {x - 12.0, axes.error.from + 8.0},
                          {},
                          ink,
                          fmt::format("{:.3g}", std::exp2(e))});
    }
    for (double e = std::ceil(axes.error.low); e <= axes.error.high; ++e) {
        const double y = axes.error.place(e);
        shapes.push_back({PlotShape::Kind::Line, {axes.time.from, y}, {axes.time.to, y}, grid, {}});
        shapes.push_back(
            {PlotShape::Kind::Text, {8.0, y - 8.0}, {}, ink, percentText(static_cast<int>(e))});
    }
    shapes.push_back({PlotShape::Kind::Text, {8.0, 10.0}, {}, ink, "error of 99 of 100 pixels"});
    shapes.push_back({PlotShape::Kind::Text,
                      {axes.time.from, axes.error.from + 28.0},
                      {},
                      ink,
                      chart.predictedFor.empty()
                          ? "time to the exact one"
                          : fmt::format("time to the exact one, predicted for {} at {} x {}",
                                        chart.predictedFor, chart.size.x, chart.size.y)});
}

/// Explains the rings, where there are any.
void addLegend(Shapes& shapes, const std::vector<Standing>& standing, glm::ivec2 size) {
    if (std::ranges::find(standing, Standing::Tie) != standing.end()) {
        const double left = size.x - 400.0;
        shapes.push_back({PlotShape::Kind::Ring, {left, 18.0}, {}, onFront, {}});
        shapes.push_back({PlotShape::Kind::Text,
                          {left + 16.0, 10.0},
                          {},
                          ink,
                          "may be on the line, too: within the noise"});
    }
}

void addFront(Shapes& shapes, const CostChart& chart, const Axes& axes,
              const std::vector<std::size_t>& front) {
    for (std::size_t i = 1; i < front.size(); ++i) {
        const CostPoint& a = chart.points[front[i - 1]];
        const CostPoint& b = chart.points[front[i]];
        shapes.push_back({PlotShape::Kind::Line,
                          axes.place(a.cost.ratio.median, errorOf(a)),
                          axes.place(b.cost.ratio.median, errorOf(b)),
                          onFront,
                          {}});
    }
}

/// Draws an arrow from a point of which only a bound is known to where its time may be; a `side` of
/// -1 points to the left.
void addArrow(Shapes& shapes, const glm::dvec2& from, double side, const glm::dvec3& color) {
    const glm::dvec2 tip = from + glm::dvec2(arrowLength * side, 0.0);
    shapes.push_back({PlotShape::Kind::Line, from, tip, color, {}});
    for (const double up : {-1.0, 1.0}) {
        const glm::dvec2 barb = tip + arrowHead * glm::dvec2(-side, up);
        shapes.push_back({PlotShape::Kind::Line, tip, barb, color, {}});
    }
}

void addPoint(Shapes& shapes, const CostPoint& point, RatioBound bound, const Axes& axes,
              Standing standing) {
    const glm::dvec3 color = standing == Standing::Beaten ? beaten : onFront;
    const auto mark = standing == Standing::Tie ? PlotShape::Kind::Ring : PlotShape::Kind::Dot;
    const glm::dvec2 at = axes.place(point.cost.ratio.median, errorOf(point));
    shapes.push_back({mark, at, {}, color, {}});
    if (bound == RatioBound::AtMost || bound == RatioBound::AtLeast) {
        return addArrow(shapes, at, bound == RatioBound::AtMost ? -1.0 : 1.0, color);
    }
    const glm::dvec2 left = axes.place(std::max(point.cost.ratio.lower, 1e-3), errorOf(point));
    const glm::dvec2 right = axes.place(std::max(point.cost.ratio.upper, 1e-3), errorOf(point));
    shapes.push_back({PlotShape::Kind::Line, left, right, color, {}});
}

/// Adds a label to each point on the front; the first point chooses first where its label goes.
void addLabels(Shapes& shapes, const CostChart& chart, const Axes& axes, glm::ivec2 size) {
    std::vector<NamedPoint> named;
    for (const std::size_t i : frontAndTies(chart.points)) {
        const CostPoint& point = chart.points[i];
        named.push_back({axes.place(point.cost.ratio.median, errorOf(point)),
                         levelsText(point.levels), point.isExact()});
    }
    std::vector<glm::dvec2> marks;
    for (const CostPoint& point : chart.points) {
        marks.push_back(axes.place(point.cost.ratio.median, errorOf(point)));
    }
    for (PlotShape& label : labelsOf(named, marks, size, onFront)) {
        shapes.push_back(std::move(label));
    }
}

} // namespace

std::vector<PlotShape> costPlot(const CostChart& chart, glm::ivec2 size) {
    const Axes axes = axesOf(chart, size);
    const std::vector<std::size_t> front = costFront(chart.points);
    const std::vector<Standing> standing = standings(chart.points);
    Shapes shapes;
    addGrid(shapes, chart, axes);
    addLegend(shapes, standing, size);
    addFront(shapes, chart, axes, front);
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        addPoint(shapes, chart.points[i], chart.boundOf(chart.points[i]), axes, standing[i]);
    }
    addLabels(shapes, chart, axes, size);
    return shapes;
}

} // namespace patina
