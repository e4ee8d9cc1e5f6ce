// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/flip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/color.h"
#include "measure/plane_filter.h"

namespace patina {
namespace {

using Planes = std::array<std::vector<double>, 3>;

constexpr double colorPower = 0.7;
constexpr double featurePower = 0.5;

/// Distances up to this share of the greatest one spread over this share of the scale.
constexpr double nearShare = 0.4;
constexpr double nearScale = 0.95;

/// The width of the eye's detector of edges, in degrees.
constexpr double detectorWidth = 0.082;

/// Linear Rec. 709 to CIE XYZ relative to the white of D65.
const glm::dmat3& toRelativeXyz() {
    static const glm::dmat3 matrix = [] {
        const glm::dmat3 xyz = glm::transpose(
            glm::dmat3(10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0,
                       2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0,
                       1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0));
        const glm::dvec3 white = xyz * glm::dvec3(1.0);
        glm::dmat3 relative = xyz;
        for (int column = 0; column < 3; ++column) {
            relative[column] /= white;
        }
        return relative;
    }();
    return matrix;
}

/// Lightness, red against green and yellow against blue: linear in light (YCxCz), or with the cube
/// root in between (L*a*b*).
glm::dvec3 opponent(const glm::dvec3& xyz) {
    return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 lightOf(const glm::dvec3& opponents) {
    static const glm::dmat3 fromXyz = glm::inverse(toRelativeXyz());
    const double y = (opponents.x + 16.0) / 116.0;
    return fromXyz * glm::dvec3(y + opponents.y / 500.0, y, y - opponents.z / 200.0);
}

double cubeRooted(double x) {
    constexpr double delta = 6.0 / 29.0;
    return x > delta * delta * delta ? std::cbrt(x) : x / (3.0 * delta * delta) + 4.0 / 29.0;
}

/// L*a*b*, with colours that count for less where it is dark (Hunt's effect).
glm::dvec3 perceived(const glm::dvec3& light) {
    const glm::dvec3 xyz = toRelativeXyz() * light;
    const glm::dvec3 lab =
        opponent({cubeRooted(xyz.x), cubeRooted(xyz.y), cubeRooted(xyz.z)});
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

/// HyAB: city blocks between lightness and colour.
double distance(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = a - b;
    return std::abs(d.x) + std::hypot(d.y, d.z);
}

/// One of the Gaussians that the eye's sensitivity to contrast is a sum of: its weight and how wide
/// it is, in squared degrees.
struct Blur {
    double weight;
    double width;
};

Kernel bell(const Blur& blur, int radius, double pixelsPerDegree) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) {
        const double degrees = x / pixelsPerDegree;
        kernel.push_back(std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees /
                                  blur.width));
    }
    return kernel;
}

double sumOf(const Kernel& kernel) {
    double sum = 0.0;
    for (const double weight : kernel) {
        sum += weight;
    }
    return sum;
}

/// A plane as the eye resolves it.
std::vector<double> blurred(const std::vector<double>& plane, glm::ivec2 size,
                            std::initializer_list<Blur> blurs, double pixelsPerDegree) {
    constexpr double widest = 0.04;
    const double reach = 3.0 * std::sqrt(widest / (2.0 * std::numbers::pi * std::numbers::pi));
    const int radius = static_cast<int>(std::ceil(reach * pixelsPerDegree));
    std::vector<double> sum(plane.size());
    double whole = 0.0;
    for (const Blur& blur : blurs) {
        const Kernel kernel = bell(blur, radius, pixelsPerDegree);
        const double height = blur.weight * std::sqrt(std::numbers::pi / blur.width);
        const std::vector<double> part = filtered(plane, size, kernel, kernel);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += height * part[i];
        }
        whole += height * sumOf(kernel) * sumOf(kernel);
    }
    for (double& value : sum) {
        value /= whole;
    }
    return sum;
}

/// Weights above 0 sum up to 1, those below to -1.
void balance(Kernel& kernel) {
    double above = 0.0;
    double below = 0.0;
    for (const double weight : kernel) {
        (weight > 0.0 ? above : below) += weight;
    }
    for (double& weight : kernel) {
        weight /= weight > 0.0 ? above : -below;
    }
}

/// The first or the second derivative of a Gaussian, and the Gaussian across it.
struct Detector {
    Kernel along;
    Kernel across;
};

Detector detector(bool ofPoints, double pixelsPerDegree) {
    const double deviation = 0.5 * detectorWidth * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    Detector made;
    for (int x = -radius; x <= radius; ++x) {
        const double g = std::exp(-x * x / (2.0 * deviation * deviation));
        made.across.push_back(g);
        made.along.push_back(ofPoints ? (x * x / (deviation * deviation) - 1.0) * g : x * g);
    }
    balance(made.along);
    const double sum = sumOf(made.across);
    for (double& weight : made.across) {
        weight /= sum;
    }
    return made;
}

std::vector<double> strength(const std::vector<double>& lightness, glm::ivec2 size,
                             const Detector& detector) {
    std::vector<double> x = filtered(lightness, size, detector.along, detector.across);
    const std::vector<double> y = filtered(lightness, size, detector.across, detector.along);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = std::hypot(x[i], y[i]);
    }
    return x;
}

} // namespace

Flip::Flip(glm::ivec2 size, const std::vector<glm::dvec3>& right, double pixelsPerDegree)
    : size_(size), pixelsPerDegree_(pixelsPerDegree),
      farthest_(std::pow(distance(perceived({0.0, 1.0, 0.0}), perceived({0.0, 0.0, 1.0})),
                         colorPower)),
      right_(seen(right)) {}

Flip::Seen Flip::seen(const std::vector<glm::dvec3>& shown) const {
    Planes planes;
    std::vector<double> lightness;
    for (const glm::dvec3& color : shown) {
        const glm::dvec3 parts = opponent(toRelativeXyz() * srgbDecoded(color));
        for (int i = 0; i < 3; ++i) {
            planes[static_cast<std::size_t>(i)].push_back(parts[i]);
        }
        lightness.push_back((parts.x + 16.0) / 116.0);
    }
    const double degree = pixelsPerDegree_;
    const std::vector<double> light = blurred(planes[0], size_, {{1.0, 0.0047}}, degree);
    const std::vector<double> red = blurred(planes[1], size_, {{1.0, 0.0053}}, degree);
    const std::vector<double> blue =
        blurred(planes[2], size_, {{34.1, 0.04}, {13.5, 0.025}}, degree);
    Seen made;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const glm::dvec3 color = lightOf({light[i], red[i], blue[i]});
        made.colors.push_back(perceived(glm::clamp(color, 0.0, 1.0)));
    }
    made.edges = strength(lightness, size_, detector(false, degree));
    made.points = strength(lightness, size_, detector(true, degree));
    return made;
}

std::vector<double> Flip::differences(const std::vector<glm::dvec3>& shown) const {
    const Seen other = seen(shown);
    std::vector<double> map(shown.size());
    for (std::size_t i = 0; i < map.size(); ++i) {
        const double apart = std::pow(distance(right_.colors[i], other.colors[i]), colorPower);
        const double limit = nearShare * farthest_;
        const double color = apart < limit ? nearScale * apart / limit
                                           : nearScale + (1.0 - nearScale) * (apart - limit) /
                                                             (farthest_ - limit);
        const double feature = std::max(std::abs(right_.edges[i] - other.edges[i]),
                                        std::abs(right_.points[i] - other.points[i]));
        const double share = std::pow(std::numbers::sqrt2 / 2.0 * feature, featurePower);
        map[i] = std::pow(color, 1.0 - share);
    }
    return map;
}

} // namespace patina
