// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/hemisphere_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace patina {
namespace {

using std::numbers::pi;

/// Is a node of a rule along one angle.
struct Node {
    double x = 0.0;
    double weight = 0.0;
};

/// Returns the zero of the Legendre polynomial of degree n near `x`, by Newton's method, and its
/// weight (Abramowitz and Stegun 25.4.29).
Node legendreNode(int n, double x) {
    double slope = 1.0;
    for (int iteration = 0; iteration < 10; ++iteration) {
        double before = 1.0;
        double value = x;
        for (int k = 2; k <= n; ++k) {
            const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
            before = value;
            value = next;
        }
        slope = n * (x * value - before) / (x * x - 1.0);
        x -= value / slope;
    }
    return {x, 2.0 / ((1.0 - x * x) * slope * slope)};
}

/// Returns the Gauss-Legendre rule of n nodes on -1 .. 1.
std::vector<Node> gaussLegendre(int n) {
    std::vector<Node> nodes;
    for (int i = 0; i < n; ++i) {
        nodes.push_back(legendreNode(n, std::cos(pi * (i + 0.75) / (n + 0.5))));
    }
    return nodes;
}

constexpr double mirrorSteps[] = {5e-4, 1.2e-3, 3e-3, 7.5e-3, 0.019, 0.047, 0.12, 0.3};
constexpr double horizonSteps[] = {1e-4, 1e-3, 1e-2, 0.05, 0.2};
constexpr double lightSteps[] = {0.03, 0.12, 0.5};

/// Is the width below which a panel is joined with the next, in radians.
constexpr double narrowest = 1e-6;

/// Returns the ends of panels from `low` to `high` that end at the breaks and are no wider than
/// `widest`.
std::vector<double> panels(std::vector<double> breaks, double low, double high, double widest) {
    std::erase_if(breaks, [&](double x) { return x < low + narrowest || x > high - narrowest; });
    breaks.push_back(low);
    breaks.push_back(high);
    std::sort(breaks.begin(), breaks.end());
    std::vector<double> ends{low};
    for (const double end : breaks) {
        const double begin = ends.back();
        if (end - begin < narrowest) {
            continue;
        }
        const int parts = static_cast<int>(std::ceil((end - begin) / widest));
        for (int i = 1; i <= parts; ++i) {
            ends.push_back(begin + (end - begin) * i / parts);
        }
    }
    return ends;
}

/// Returns panels of the angle from the normal, 0 .. pi/2; light and mirror direction are both at
/// `theta`.
std::vector<double> polarPanels(double theta, double widest) {
    std::vector<double> breaks{theta};
    for (const double step : mirrorSteps) {
        breaks.push_back(theta - step);
        breaks.push_back(theta + step);
    }
    for (const double step : horizonSteps) {
        breaks.push_back(pi / 2 - step);
    }
    return panels(std::move(breaks), 0.0, pi / 2, widest);
}

/// Returns panels of the azimuth from the light, 0 .. 2 pi; the mirror direction is at pi.
std::vector<double> azimuthPanels(double widest) {
    std::vector<double> breaks{pi};
    for (const double step : mirrorSteps) {
        breaks.push_back(pi - step);
        breaks.push_back(pi + step);
    }
    for (const double step : lightSteps) {
        breaks.push_back(step);
        breaks.push_back(2.0 * pi - step);
    }
    return panels(std::move(breaks), 0.0, 2.0 * pi, widest);
}

std::vector<Node> composite(const std::vector<double>& ends, const std::vector<Node>& rule) {
    std::vector<Node> all;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double half = 0.5 * (ends[i] - ends[i - 1]);
        for (const Node& node : rule) {
            all.push_back({ends[i - 1] + half * (1.0 + node.x), half * node.weight});
        }
    }
    return all;
}

} // namespace

std::vector<WeightedDirection> hemisphereRule(const glm::dvec3& l, const HemisphereRuleSize& size) {
    const glm::dvec3 light = glm::normalize(l);
    const double theta = std::atan2(std::hypot(light.x, light.y), light.z);
    const double turn = std::atan2(light.y, light.x);
    const std::vector<Node> rule = gaussLegendre(size.nodes);
    const auto rings = composite(polarPanels(theta, size.widestPanel), rule);
    const auto sectors = composite(azimuthPanels(size.widestPanel), rule);
    std::vector<WeightedDirection> all;
    all.reserve(rings.size() * sectors.size());
    for (const Node& ring : rings) {
        const double s = std::sin(ring.x);
        const double c = std::cos(ring.x);
        for (const Node& sector : sectors) {
            const double phi = turn + sector.x;
            all.push_back({{s * std::cos(phi), s * std::sin(phi), c},
                           ring.weight * sector.weight * s * c / pi});
        }
    }
    return all;
}

} // namespace patina
