// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plot_shapes.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "assets/asset_client.h"
#include "cli/cost_request.h"
#include "core/atomic_file.h"
#include "core/display_image.h"
#include "core/label.h"
#include "core/text.h"

namespace patina {
namespace {

constexpr double dotRadius = 5.0;
constexpr double ringRadius = 8.0; ///< is larger than a dot, so that both are seen at one place

std::string svgColor(const glm::dvec3& color) {
    return fmt::format("rgb({:.0f},{:.0f},{:.0f})", 255.0 * color.r, 255.0 * color.g,
                       255.0 * color.b);
}

std::string svgOf(const PlotShape& shape) {
    const std::string color = svgColor(shape.color);
    switch (shape.kind) {
    case PlotShape::Kind::Line:
        return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" "
                           "stroke=\"{}\"/>\n",
                           shape.from.x, shape.from.y, shape.to.x, shape.to.y, color);
    case PlotShape::Kind::Dashes:
        return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" "
                           "stroke=\"{}\" stroke-dasharray=\"5 4\"/>\n",
                           shape.from.x, shape.from.y, shape.to.x, shape.to.y, color);
    case PlotShape::Kind::Rectangle:
        return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
                           "height=\"{:.1f}\" fill=\"{}\"/>\n",
                           shape.from.x, shape.from.y, shape.to.x - shape.from.x,
                           shape.to.y - shape.from.y, color);
    case PlotShape::Kind::Ring:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.0f}\" fill=\"none\" "
                           "stroke=\"{}\" stroke-width=\"2\"/>\n",
                           shape.from.x, shape.from.y, ringRadius, color);
    case PlotShape::Kind::Dot:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.0f}\" fill=\"{}\"/>\n",
                           shape.from.x, shape.from.y, dotRadius, color);
    default:
        return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", shape.from.x,
                           shape.from.y + 12.0, color, escapedForXml(shape.text));
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

/// Mixes a colour over a pixel.
void blend(Image& image, int x, int y, const glm::dvec3& color, double share) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height || !(share > 0.0)) {
        return;
    }
    const std::size_t at = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
    for (int i = 0; i < 3; ++i) {
        float& part = image.pixels[at + std::size_t(i)];
        part = static_cast<float>((1.0 - share) * part + share * color[i]);
    }
}

/// Draws a line about a pixel wide with smooth sides: along its longer direction, each step shares
/// its ink between the pixels beside the line.
void drawLine(Image& image, const PlotShape& line) {
    const glm::dvec2 way = line.to - line.from;
    const bool isSteep = std::abs(way.y) > std::abs(way.x);
    const int along = isSteep ? 1 : 0;
    const int steps = static_cast<int>(std::ceil(std::abs(way[along])));
    for (int i = 0; i <= steps; ++i) {
        const int dash = line.kind == PlotShape::Kind::Dashes ? i % 9 : 0;
        if (dash >= 5) {
            continue;
        }
        const glm::dvec2 at = line.from + way * (steps > 0 ? double(i) / steps : 0.0);
        const double side = at[1 - along] - 0.5;
        const double low = std::floor(side);
        for (const double each : {low, low + 1.0}) {
            const double share = 1.0 - std::abs(side - each);
            const int x = static_cast<int>(isSteep ? each : at.x);
            const int y = static_cast<int>(isSteep ? at.y : each);
            blend(image, x, y, line.color, share);
        }
    }
}

void drawRectangle(Image& image, const PlotShape& rectangle) {
    const glm::ivec2 low(glm::round(rectangle.from));
    const glm::ivec2 high(glm::round(rectangle.to));
    for (int y = low.y; y < high.y; ++y) {
        for (int x = low.x; x < high.x; ++x) {
            put(image, x, y, rectangle.color);
        }
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
    switch (shape.kind) {
    case PlotShape::Kind::Line:
    case PlotShape::Kind::Dashes:
        return drawLine(image, shape);
    case PlotShape::Kind::Rectangle:
        return drawRectangle(image, shape);
    case PlotShape::Kind::Text:
        return drawLabel(image, shape.text, glm::ivec2(shape.from), 1, image.width);
    default:
        return drawDot(image, shape);
    }
}

} // namespace

std::string plotSvg(const std::vector<PlotShape>& shapes, glm::ivec2 size) {
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
                                  "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
                                  "<rect width=\"{0}\" height=\"{1}\" fill=\"{2}\"/>\n",
                                  size.x, size.y, svgColor(plot_colors::paper));
    for (const PlotShape& shape : shapes) {
        svg += svgOf(shape);
    }
    return svg + "</svg>\n";
}

Image plotImage(const std::vector<PlotShape>& shapes, glm::ivec2 size) {
    Image image{size.x, size.y, 3, {}};
    image.pixels.assign(std::size_t(size.x) * std::size_t(size.y) * 3, float(plot_colors::paper.r));
    for (const PlotShape& shape : shapes) {
        draw(image, shape);
    }
    return image;
}

Result<void> writeDrawing(const std::vector<PlotShape>& shapes, glm::ivec2 size,
                          const std::string& file) {
    if (endingOf(file) == ".svg") {
        return writeFileAtomically(file, plotSvg(shapes, size));
    }
    AssetClient files;
    return files.saveImage(file, linearFromDisplay(plotImage(shapes, size)));
}

} // namespace patina
