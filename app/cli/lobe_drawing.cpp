// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/lobe_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <glm/common.hpp>


namespace patina {
namespace {

constexpr glm::dvec3 subjectColors[] = {{1.0, 0.72, 0.3}, {0.35, 0.7, 1.0},  {0.55, 0.85, 0.4},
                                        {0.9, 0.5, 0.85}, {0.95, 0.45, 0.4}, {0.4, 0.85, 0.8}};
constexpr glm::dvec3 channelColors[] = {{1.0, 0.42, 0.36}, {0.45, 0.85, 0.4}, {0.45, 0.62, 1.0}};

constexpr double edgeLeft = 60.0;
constexpr double edgeRight = 270.0; ///< pixels; the legend stands there
constexpr double edgeTop = 34.0;
constexpr double edgeBottom = 46.0;
constexpr double textHeight = 15.0;

/// Is a line as it is drawn: points over degrees or nanometres.
struct DrawnLine {
    std::vector<glm::dvec2> points;
    glm::dvec3 color{1.0};
    bool isDashed = false;
    std::string name;       ///< is in the legend; empty: it is not
    bool isShare = false;   ///< is a share of the light where the plot's others are not
    bool isSampled = false; ///< is known at its points alone
};

template <class Number>
DrawnLine drawnLine(const LobeLine& line, const glm::dvec3& color, const std::string& name,
                    const Number& number) {
    DrawnLine drawn{{}, color, line.stroke != LobeStroke::Main, name, line.isShare, line.isSampled};
    for (std::size_t i = 0; i < line.values.size(); ++i) {
        drawn.points.emplace_back(line.at[i], number(line.values[i]));
    }
    return drawn;
}

/// Returns the colour of a line that is one of several of the same material.
glm::dvec3 strokeColor(const LobeLine& line, const glm::dvec3& color) {
    constexpr glm::dvec3 across(0.95, 0.55, 0.4);
    constexpr glm::dvec3 along(0.45, 0.75, 0.95);
    const glm::dvec3 own = line.stroke == LobeStroke::Across       ? across
                           : line.stroke == LobeStroke::Along      ? along
                           : line.stroke == LobeStroke::Extinction ? along
                                                                   : color;
    return line.isFromInside ? 0.7 * own : own;
}

std::vector<DrawnLine> drawnLines(const std::vector<LobeSubject>& subjects, LobePlot plot) {
    std::vector<DrawnLine> all;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const LobeSubject& subject = subjects[i];
        const bool isAlone = subjects.size() == 1;
        for (const LobeLine& line : subject.lines.lines) {
            const bool isFirst = &line == &subject.lines.lines.front();
            const std::string name = isAlone ? line.name : isFirst ? subject.name : std::string();
            if (isAlone && !isGrey(line)) {
                for (int channel = 0; channel < 3; ++channel) {
                    all.push_back(drawnLine(line, channelColors[channel],
                                            channel == 1 ? name : std::string(),
                                            [channel](const glm::dvec3& v) { return v[channel]; }));
                }
                continue;
            }
            const glm::dvec3& own = subjectColors[i % std::size(subjectColors)];
            all.push_back(
                drawnLine(line, isAlone ? strokeColor(line, own) : own, name,
                          [plot](const glm::dvec3& v) { return overlaidValue(plot, v); }));
        }
    }
    return all;
}

/// Returns a plot's title, and what it draws for channels that differ.
std::string titleText(std::string title, const std::vector<LobeSubject>& subjects, LobePlot plot) {
    const std::string_view word = overlaidWord(plot, subjects);
    return word.empty() ? title : fmt::format("{} ({})", title, word);
}

/// Returns the largest value of all lines at places up to one.
double largestOf(const std::vector<DrawnLine>& lines,
                 double upTo = std::numeric_limits<double>::infinity()) {
    double largest = 0.0;
    for (const DrawnLine& line : lines) {
        for (const glm::dvec2& point : line.points) {
            largest = point.x <= upTo ? std::max(largest, point.y) : largest;
        }
    }
    return largest;
}

void addText(std::vector<PlotShape>& shapes, const glm::dvec2& at, const std::string& text,
             const glm::dvec3& color = plot_colors::ink) {
    shapes.push_back({PlotShape::Kind::Text, at, {}, color, text});
}

void addLine(std::vector<PlotShape>& shapes, const glm::dvec2& from, const glm::dvec2& to,
             const glm::dvec3& color, bool isDashed = false) {
    shapes.push_back(
        {isDashed ? PlotShape::Kind::Dashes : PlotShape::Kind::Line, from, to, color, {}});
}

/// Adds a line through places, cut into dashes by its own length where it is dashed.
void addPath(std::vector<PlotShape>& shapes, const std::vector<glm::dvec2>& places,
             const DrawnLine& line) {
    constexpr double dash = 6.0;
    double way = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const glm::dvec2 step = places[i] - places[i - 1];
        const double length = std::hypot(step.x, step.y);
        const int parts = line.isDashed ? static_cast<int>(std::ceil(length / dash)) : 1;
        for (int part = 0; part < parts; ++part) {
            const bool isGap = line.isDashed && std::fmod(way, 2.0 * dash) >= dash;
            way += length / parts;
            if (!isGap) {
                addLine(shapes, places[i - 1] + step * (double(part) / parts),
                        places[i - 1] + step * (double(part + 1) / parts), line.color);
            }
        }
    }
}

/// Adds the names of lines at the right, and below them what the lines leave out.
void addLegend(std::vector<PlotShape>& shapes, const std::vector<DrawnLine>& lines,
               const std::vector<LobeSubject>& subjects, glm::ivec2 size, bool isSpectrum = false) {
    constexpr double sample = 16.0;
    constexpr std::size_t longest = 30; ///< letters of a name that have room
    const double left = size.x - edgeRight + 30.0;
    double y = edgeTop;
    if (subjects.size() == 1) { // of several the lines have the names
        addText(shapes, {left, y}, subjects.front().name.substr(0, longest));
        y += 1.5 * textHeight;
    }
    for (const DrawnLine& line : lines) {
        if (line.name.empty()) {
            continue;
        }
        addLine(shapes, {left, y + 8.0}, {left + sample, y + 8.0}, line.color, line.isDashed);
        addText(shapes, {left + sample + 6.0, y}, line.name.substr(0, longest));
        y += textHeight;
    }
    y += textHeight;
    std::set<std::string> named; // several materials may have the same
    for (const LobeSubject& subject : subjects) {
        for (const LobeMark& mark : subject.lines.marks) {
            const std::string text = fmt::format("{} {:.{}f}{}", mark.name, mark.at,
                                                 isSpectrum ? 0 : 2, isSpectrum ? " nm" : "");
            if (named.insert(text).second) {
                addText(shapes, {left, y}, text);
                y += textHeight;
            }
        }
    }
    for (const LobeSubject& subject : subjects) {
        if (!subject.lines.note.empty()) {
            addText(shapes, {edgeLeft, size.y - 18.0},
                    subjects.size() == 1 ? subject.lines.note
                                         : fmt::format("{}: {}", subject.name, subject.lines.note));
            break; // there is room for one
        }
    }
}

/// Places an angle and a length in a half disc.
struct HalfDisc {
    glm::dvec2 center{0.0};
    double radius = 1.0;

    glm::dvec2 place(double degrees, double length) const {
        const double angle = degrees * std::numbers::pi / 180.0;
        return center + radius * length * glm::dvec2(std::sin(angle), -std::cos(angle));
    }
};

void addDiscGrid(std::vector<PlotShape>& shapes, const HalfDisc& disc, LobeScale scale,
                 double largest) {
    for (const double length : {0.25, 0.5, 0.75, 1.0}) {
        for (int degrees = -90; degrees < 90; degrees += 3) {
            addLine(shapes, disc.place(degrees, length), disc.place(degrees + 3.0, length),
                    plot_colors::grid);
        }
        addText(shapes, disc.place(90.0, length) + glm::dvec2(-18.0, 6.0),
                fmt::format("{:.3g}", valueAtLength(scale, length, largest)));
    }
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        addLine(shapes, disc.center, disc.place(degrees, 1.0), plot_colors::grid);
        addText(shapes, disc.place(degrees, 1.05) - glm::dvec2(9.0, 8.0),
                fmt::format("{}", std::abs(degrees)));
    }
}

/// Places an angle up to 90 degrees, and a number, on straight axes.
struct AngleAxes {
    double right = 0.0;
    double bottom = 0.0;
    double top = 1.0;   ///< is the number at the top
    double first = 0.0; ///< degrees at the left

    glm::dvec2 place(double degrees, double number) const {
        return {edgeLeft + (right - edgeLeft) * (degrees - first) / (90.0 - first),
                bottom + (edgeTop - bottom) * number / top};
    }
};

void addAngleGrid(std::vector<PlotShape>& shapes, const AngleAxes& axes, int step) {
    for (int degrees = static_cast<int>(axes.first); degrees <= 90; degrees += step) {
        addLine(shapes, axes.place(degrees, 0.0), axes.place(degrees, axes.top), plot_colors::grid);
        addText(shapes, axes.place(degrees, 0.0) + glm::dvec2(-8.0, 8.0),
                fmt::format("{}", degrees));
    }
    for (int i = 0; i <= 5; ++i) {
        const double number = axes.top * i / 5.0;
        addLine(shapes, axes.place(axes.first, number), axes.place(90.0, number),
                plot_colors::grid);
        addText(shapes, axes.place(axes.first, number) - glm::dvec2(46.0, 8.0),
                fmt::format("{:.3g}", number));
    }
}

void addLines(std::vector<PlotShape>& shapes, const std::vector<DrawnLine>& lines,
              const AngleAxes& axes) {
    for (const DrawnLine& line : lines) {
        std::vector<glm::dvec2> places;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const glm::dvec2& point = line.points[i];
            if (point.y <= axes.top) {
                places.push_back(axes.place(point.x, point.y));
            } else if (i > 0 && line.points[i - 1].y <= axes.top) { // it leaves the plot here
                const glm::dvec2& last = line.points[i - 1];
                const double share = (axes.top - last.y) / (point.y - last.y);
                places.push_back(axes.place(glm::mix(last.x, point.x, share), axes.top));
                break;
            }
        }
        addPath(shapes, places, line);
    }
}

/// Places a wavelength, and an index or a share, on straight axes.
struct SpectrumAxes {
    double right = 0.0;
    double bottom = 0.0;
    glm::dvec2 wavelengths{1e300, -1e300}; ///< are the first and the last, in nanometres
    glm::dvec2 values{1e300, -1e300};      ///< are the least and the most of an index
    double largestShare = 0.0;

    void add(const glm::dvec2& point, bool isShare) {
        wavelengths = {std::min(wavelengths.x, point.x), std::max(wavelengths.y, point.x)};
        if (isShare) {
            largestShare = std::max(largestShare, point.y);
        } else {
            values = {std::min(values.x, point.y), std::max(values.y, point.y)};
        }
    }

    /// Leaves room about the lines.
    void fit() {
        const double spread = std::max(values.y - values.x, 0.02);
        values = {std::max(values.x - 0.25 * spread, 0.0), values.y + 0.25 * spread};
        largestShare = largestShare > 0.0 ? 1.25 * largestShare : 1.0;
    }

    glm::dvec2 place(const glm::dvec2& point, bool isShare) const {
        const double across = (point.x - wavelengths.x) / (wavelengths.y - wavelengths.x);
        const double up =
            isShare ? point.y / largestShare : (point.y - values.x) / (values.y - values.x);
        return {edgeLeft + (right - edgeLeft) * across, bottom + (edgeTop - bottom) * up};
    }
};

void addSpectrumGrid(std::vector<PlotShape>& shapes, const SpectrumAxes& axes) {
    constexpr double step = 50.0; ///< nm
    for (double nm = step * std::ceil(axes.wavelengths.x / step); nm <= axes.wavelengths.y;
         nm += step) {
        addLine(shapes, axes.place({nm, axes.values.x}, false),
                axes.place({nm, axes.values.y}, false), plot_colors::grid);
        addText(shapes, axes.place({nm, axes.values.x}, false) + glm::dvec2(-12.0, 8.0),
                fmt::format("{}", nm));
    }
    for (int i = 0; i <= 5; ++i) {
        const double share = i / 5.0;
        const double value = axes.values.x + share * (axes.values.y - axes.values.x);
        const glm::dvec2 left = axes.place({axes.wavelengths.x, value}, false);
        const glm::dvec2 end = axes.place({axes.wavelengths.y, value}, false);
        addLine(shapes, left, end, plot_colors::grid);
        addText(shapes, left - glm::dvec2(50.0, 8.0), fmt::format("{:.4g}", value));
        addText(shapes, end + glm::dvec2(6.0, -8.0),
                fmt::format("{:.3g}", share * axes.largestShare));
    }
}

/// Returns the end of an axis that a largest value fits on: a round number.
double axisEnd(double largest) {
    if (!(largest > 1.02)) {
        return 1.0;
    }
    const double magnitude = std::pow(10.0, std::floor(std::log10(largest)));
    for (const double step : {1.2, 1.5, 2.0, 3.0, 5.0}) {
        if (largest <= step * magnitude) {
            return step * magnitude;
        }
    }
    return 10.0 * magnitude;
}

/// Says what a polar plot is of: "f in 1/sr", or a factor by its name.
std::string valueText(const std::vector<LobeSubject>& subjects) {
    const LobeLine& line = subjects.front().lines.lines.front();
    const std::string name = line.name == "reflectance" ? "f" : line.name;
    return line.isShare ? name + ", of 1" : name + " in 1/sr";
}

/// Adds what is transmitted at the right, where lines are what an interface reflects; returns
/// whether they are.
bool addTransmitted(std::vector<PlotShape>& shapes, const std::vector<LobeSubject>& subjects,
                    const AngleAxes& axes) {
    const bool hasInterface = std::ranges::any_of(subjects, [](const LobeSubject& subject) {
        return std::ranges::any_of(subject.lines.lines, [](const LobeLine& line) {
            return transmittedLine(line).has_value();
        });
    });
    for (int i = 0; hasInterface && i <= 5; ++i) {
        const double reflected = axes.top * i / 5.0;
        addText(shapes, axes.place(90.0, reflected) + glm::dvec2(4.0, -8.0),
                fmt::format("{:.3g}", 1.0 - reflected));
    }
    return hasInterface;
}

} // namespace

std::vector<PlotShape> polarDrawing(const std::vector<LobeSubject>& subjects, LobeScale scale,
                                    double lightDegrees, glm::ivec2 size) {
    const std::vector<DrawnLine> lines = drawnLines(subjects, LobePlot::Polar);
    const double largest = std::max(largestOf(lines), 1e-300);
    const double width = size.x - edgeRight - edgeLeft;
    const double height = size.y - edgeTop - edgeBottom - 20.0;
    const HalfDisc disc{{edgeLeft + 0.5 * width, size.y - edgeBottom - 14.0},
                        std::min(0.5 * width, height)};
    std::vector<PlotShape> shapes;
    addDiscGrid(shapes, disc, scale, largest);
    addLine(shapes, disc.center, disc.place(-lightDegrees, 1.0), plot_colors::ink, true);
    addText(shapes, {8.0, 8.0},
            titleText(fmt::format("{}, {}, light at {:g} degrees", valueText(subjects),
                                  wordOf(scale), lightDegrees),
                      subjects, LobePlot::Polar));
    for (const DrawnLine& line : lines) {
        std::vector<glm::dvec2> places;
        for (const glm::dvec2& point : line.points) {
            places.push_back(disc.place(point.x, lobeLength(scale, point.y, largest)));
        }
        addPath(shapes, places, line);
    }
    addLegend(shapes, lines, subjects, size);
    return shapes;
}

std::vector<PlotShape> shareDrawing(const std::vector<LobeSubject>& subjects, glm::ivec2 size) {
    const std::vector<DrawnLine> lines = drawnLines(subjects, LobePlot::Albedo);
    const AngleAxes axes{size.x - edgeRight, size.y - edgeBottom,
                         axisEnd(largestOf(lines, roomyDegrees)), 0.0};
    std::vector<PlotShape> shapes;
    addAngleGrid(shapes, axes, 15);
    if (axes.top > 1.0) {
        addLine(shapes, axes.place(0.0, 1.0), axes.place(90.0, 1.0), {0.9, 0.25, 0.2});
        addText(shapes, axes.place(90.0, 1.0) + glm::dvec2(4.0, -8.0), "1", {0.9, 0.25, 0.2});
    }
    for (const LobeSubject& subject : subjects) {
        for (const LobeMark& mark : subject.lines.marks) {
            addLine(shapes, axes.place(mark.at, 0.0), axes.place(mark.at, axes.top),
                    {0.5, 0.5, 0.5}, true);
        }
    }
    const bool hasTransmitted = addTransmitted(shapes, subjects, axes);
    addText(shapes, {8.0, 8.0},
            titleText(hasTransmitted
                          ? "reflected R (at the left) and transmitted T (at the right), of the "
                            "light, over its angle from the normal in degrees"
                          : "share of the light over its angle from the normal in degrees",
                      subjects, LobePlot::Albedo));
    addLines(shapes, lines, axes);
    addLegend(shapes, lines, subjects, size);
    return shapes;
}

std::vector<PlotShape> spectrumDrawing(const std::vector<LobeSubject>& subjects, glm::ivec2 size) {
    std::vector<DrawnLine> lines = drawnLines(subjects, LobePlot::Spectrum);
    for (DrawnLine& line : lines) {
        if (line.isShare) {
            line.isDashed = true;
            line.color *= 0.75;
            line.name = subjects.size() == 1 ? line.name : std::string();
        }
    }
    SpectrumAxes axes;
    axes.right = size.x - edgeRight - 30.0;
    axes.bottom = size.y - edgeBottom;
    for (const DrawnLine& line : lines) {
        for (const glm::dvec2& point : line.points) {
            axes.add(point, line.isShare);
        }
    }
    axes.fit();
    std::vector<PlotShape> shapes;
    addSpectrumGrid(shapes, axes);
    for (const LobeSubject& subject : subjects) {
        for (const LobeMark& mark : subject.lines.marks) {
            addLine(shapes, axes.place({mark.at, axes.values.x}, false),
                    axes.place({mark.at, axes.values.y}, false), {0.5, 0.5, 0.5}, true);
        }
    }
    addText(shapes, {8.0, 8.0},
            "index of refraction (at the left) and R facing the surface (at the "
            "right) over the wavelength in nm");
    for (const DrawnLine& line : lines) {
        std::vector<glm::dvec2> places;
        for (const glm::dvec2& point : line.points) {
            places.push_back(axes.place(point, line.isShare));
            if (line.isSampled) {
                shapes.push_back({PlotShape::Kind::Dot, places.back(), {}, line.color, {}});
            }
        }
        addPath(shapes, places, line);
    }
    addLegend(shapes, lines, subjects, size, true);
    return shapes;
}

std::vector<PlotShape> errorDrawing(const std::vector<LobeSubject>& subjects, LobePlot plot,
                                    glm::ivec2 size) {
    const std::vector<DrawnLine> lines = drawnLines(subjects, plot);
    const AngleAxes axes{size.x - edgeRight, size.y - edgeBottom, axisEnd(largestOf(lines)), -90.0};
    std::vector<PlotShape> shapes;
    addAngleGrid(shapes, axes, 30);
    addText(shapes, {8.0, 8.0},
            titleText(std::string(plot == LobePlot::Float16 ? "floats of 16 bits"
                                                            : "float32 on the device") +
                          " against double, units in the last place over the viewer's angle",
                      subjects, plot));
    addLines(shapes, lines, axes);
    addLegend(shapes, lines, subjects, size);
    return shapes;
}

std::vector<PlotShape> sliceDrawing(const HalfDifferenceSlice& slice, const std::string& name,
                                    LobeScale scale, glm::ivec2 size) {
    const double white = whiteOf(std::array{&slice});
    const double edge = std::min(size.x - edgeRight - edgeLeft, size.y - edgeTop - edgeBottom);
    const double cell = edge / slice.size;
    const glm::dvec2 corner(edgeLeft, edgeTop + edge);
    std::vector<PlotShape> shapes;
    for (int row = 0; row < slice.size; ++row) {
        for (int column = 0; column < slice.size; ++column) {
            const glm::dvec3 color = shownColor(slice.at(column, row), scale, white);
            const glm::dvec2 low = corner + cell * glm::dvec2(column, -(row + 1));
            shapes.push_back({PlotShape::Kind::Rectangle, low, low + glm::dvec2(cell), color, {}});
        }
    }
    for (int degrees = 0; degrees <= 90; degrees += 30) {
        const double along = edge * degrees / 90.0;
        addText(shapes, corner + glm::dvec2(along - 8.0, 6.0), fmt::format("{}", degrees));
        addText(shapes, corner + glm::dvec2(-34.0, -along - 8.0), fmt::format("{}", degrees));
    }
    addText(shapes, {8.0, 8.0}, "light from the half vector, upwards, in degrees");
    addText(shapes, corner + glm::dvec2(0.0, 24.0),
            "half vector from the normal, to the right, in degrees");
    addText(shapes, {edgeLeft + edge + 20.0, edgeTop}, name);
    addText(shapes, {edgeLeft + edge + 20.0, edgeTop + 2.0 * textHeight},
            fmt::format("white: {:.3g} 1/sr or more, {}", white, wordOf(scale)));
    return shapes;
}

} // namespace patina
