// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cost_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/plot_labels.h"
#include "core/label.h"

namespace patina {
namespace {

using Shapes = std::vector<PlotShape>;

constexpr glm::dvec3 paper(0.11);
constexpr glm::dvec3 grid(0.26);
constexpr glm::dvec3 ink(0.85);
constexpr glm::dvec3 onFront(1.0, 0.72, 0.3);
constexpr glm::dvec3 beaten(0.5, 0.6, 0.7);

constexpr double marginLeft = 90.0;
constexpr double marginRight = 150.0;
constexpr double marginTop = 40.0;
constexpr double marginBottom = 50.0;
constexpr double dotRadius = 5.0;
constexpr double ringRadius = 8.0; ///< is larger than a dot, so that both are seen at one place
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

void addGrid(Shapes& shapes, const Axes& axes) {
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
                      "time to the exact one"});
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

std::string svgColor(const glm::dvec3& color) {
    return fmt::format("rgb({:.0f},{:.0f},{:.0f})", 255.0 * color.r, 255.0 * color.g,
                       255.0 * color.b);
}

std::string svgText(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return safe;
}

std::string svgOf(const PlotShape& shape) {
    const std::string color = svgColor(shape.color);
    switch (shape.kind) {
    case PlotShape::Kind::Line:
        return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" "
                           "stroke=\"{}\"/>\n",
                           shape.from.x, shape.from.y, shape.to.x, shape.to.y, color);
    case PlotShape::Kind::Ring:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.0f}\" fill=\"none\" "
                           "stroke=\"{}\" stroke-width=\"2\"/>\n",
                           shape.from.x, shape.from.y, ringRadius, color);
    case PlotShape::Kind::Dot:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.0f}\" fill=\"{}\"/>\n",
                           shape.from.x, shape.from.y, dotRadius, color);
    default:
        return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", shape.from.x,
                           shape.from.y + 12.0, color, svgText(shape.text));
    }
}

void put(Image& image, int x, int y, const glm::dvec3& color) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) {
        return;
    }
    const std::size_t at = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
    for (int i = 0; i < 3; ++i) {
        image.pixels[at + std::size_t(i)] = static_cast<float>(color[i]);
    }
}

void drawLine(Image& image, const PlotShape& line) {
    const glm::dvec2 way = line.to - line.from;
    const int steps = static_cast<int>(std::ceil(std::max(std::abs(way.x), std::abs(way.y))));
    for (int i = 0; i <= steps; ++i) {
        const glm::dvec2 at = line.from + way * (steps > 0 ? double(i) / steps : 0.0);
        put(image, static_cast<int>(at.x), static_cast<int>(at.y), line.color);
    }
}

void drawDot(Image& image, const PlotShape& dot) {
    const bool isRing = dot.kind == PlotShape::Kind::Ring;
    const int radius = static_cast<int>(isRing ? ringRadius : dotRadius);
    const int hole = isRing ? (radius - 2) * (radius - 2) : -1; // its squared radius
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            if (x * x + y * y <= radius * radius && x * x + y * y > hole) {
                put(image, static_cast<int>(dot.from.x) + x, static_cast<int>(dot.from.y) + y,
                    dot.color);
            }
        }
    }
}

void draw(Image& image, const PlotShape& shape) {
    if (shape.kind == PlotShape::Kind::Line) {
        drawLine(image, shape);
    } else if (shape.kind != PlotShape::Kind::Text) {
        drawDot(image, shape);
    } else {
        drawLabel(image, shape.text, glm::ivec2(shape.from), 1, image.width);
    }
}

} // namespace

std::vector<PlotShape> costPlot(const CostChart& chart, glm::ivec2 size) {
    const Axes axes = axesOf(chart, size);
    const std::vector<std::size_t> front = costFront(chart.points);
    const std::vector<Standing> standing = standings(chart.points);
    Shapes shapes;
    addGrid(shapes, axes);
    addLegend(shapes, standing, size);
    addFront(shapes, chart, axes, front);
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        addPoint(shapes, chart.points[i], chart.boundOf(chart.points[i]), axes, standing[i]);
    }
    addLabels(shapes, chart, axes, size);
    return shapes;
}

std::string plotSvg(const std::vector<PlotShape>& shapes, glm::ivec2 size) {
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
                                  "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
                                  "<rect width=\"{0}\" height=\"{1}\" fill=\"{2}\"/>\n",
                                  size.x, size.y, svgColor(paper));
    for (const PlotShape& shape : shapes) {
        svg += svgOf(shape);
    }
    return svg + "</svg>\n";
}

Image plotImage(const std::vector<PlotShape>& shapes, glm::ivec2 size) {
    Image image{size.x, size.y, 3, {}};
    image.pixels.assign(std::size_t(size.x) * std::size_t(size.y) * 3, float(paper.r));
    for (const PlotShape& shape : shapes) {
        draw(image, shape);
    }
    return image;
}

} // namespace patina
