// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plot_labels.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace patina {
namespace {

constexpr double samePlace = 11.0; ///< pixels; points nearer than this cannot be told apart
constexpr double lineHeight = 14.0;
/// Pixels; the width of most letters, in the picture and in the SVG file.
constexpr double letterWidth = 7.0;
constexpr double beside = 8.0; ///< pixels between a point and its label
constexpr double markRadius = 6.0;

struct Place {
    glm::dvec2 at{0.0};
    std::string name;
    bool isMain = false;
    int more = 0; ///< counts the points besides the named one
};

struct Box {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};

    bool meets(const Box& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
               other.low.y < high.y;
    }
};

void add(std::vector<Place>& places, const NamedPoint& point) {
    const auto found = std::ranges::find_if(places, [&point](const Place& place) {
        const glm::dvec2 way = glm::abs(place.at - point.at);
        return std::max(way.x, way.y) < samePlace;
    });
    if (found == places.end()) {
        places.push_back({point.at, point.name, point.isMain, 0});
        return;
    }
    ++found->more;
    if (point.isMain && !found->isMain) {
        found->name = point.name;
        found->isMain = true;
    }
}

std::string textOf(const Place& place) {
    return place.more > 0 ? fmt::format("{} and {} more", place.name, place.more) : place.name;
}

/// Returns a free box for a label: to the right of its point and above it, or else at another side;
/// nothing where all are taken.
std::optional<Box> boxOf(const Place& place, const std::vector<Box>& taken, glm::ivec2 size) {
    const glm::dvec2 extent{letterWidth * double(textOf(place).size()), lineHeight};
    const double right = beside;
    const double left = -beside - extent.x;
    const double above = -beside - 0.5 * lineHeight;
    const double below = 0.5 * beside;
    const std::array ways{glm::dvec2(right, above),
                          glm::dvec2(right, below),
                          glm::dvec2(left, above),
                          glm::dvec2(left, below),
                          glm::dvec2(right, above - lineHeight),
                          glm::dvec2(right, below + lineHeight)};
    for (const glm::dvec2& way : ways) {
        const Box box{place.at + way, place.at + way + extent};
        const bool isInside = box.low.x >= 0.0 && box.high.x <= double(size.x);
        if (isInside &&
            std::ranges::none_of(taken, [&box](const Box& other) { return box.meets(other); })) {
            return box;
        }
    }
    return std::nullopt;
}

} // namespace

std::vector<PlotShape> labelsOf(const std::vector<NamedPoint>& points,
                                const std::vector<glm::dvec2>& marks, glm::ivec2 size,
                                const glm::dvec3& color) {
    std::vector<Place> places;
    for (const NamedPoint& point : points) {
        add(places, point);
    }
    std::vector<Box> taken;
    std::vector<Box> takenOrMarked;
    for (const glm::dvec2& mark : marks) {
        takenOrMarked.push_back({mark - markRadius, mark + markRadius});
    }
    std::vector<PlotShape> labels;
    for (const Place& place : places) {
        std::optional<Box> box = boxOf(place, takenOrMarked, size);
        if (!box) {
            box = boxOf(place, taken, size);
        }
        if (!box) {
            continue;
        }
        taken.push_back(*box);
        takenOrMarked.push_back(*box);
        labels.push_back({PlotShape::Kind::Text, box->low, {}, color, textOf(place)});
    }
    return labels;
}

} // namespace patina
