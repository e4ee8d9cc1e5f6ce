// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <memory>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/color.h"
#include "measure/error/plane_filter.h"

namespace patina {
namespace {

using Planes = std::array<std::vector<double>, 3>;

constexpr double colorPower = 0.7;
constexpr double featurePower = 0.5;

/// Map distances up to nearShare of the greatest one to 0 .. nearScale, as the paper's p_c and p_t.
constexpr double nearShare = 0.4;
constexpr double nearScale = 0.95;

/// Is the width of the eye's detector of edges, in degrees.
constexpr double detectorWidth = 0.082;

/// Returns the matrix from linear Rec. 709 to CIE XYZ relative to the white of D65.
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

/// Returns lightness, red against green and yellow against blue: YCxCz of linear XYZ, or L*a*b* of
/// XYZ to the cube root.
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

/// Returns L*a*b* with less colour where it is dark (Hunt's effect).
glm::dvec3 perceived(const glm::dvec3& light) {
    const glm::dvec3 xyz = toRelativeXyz() * light;
    const glm::dvec3 lab = opponent({cubeRooted(xyz.x), cubeRooted(xyz.y), cubeRooted(xyz.z)});
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

/// Returns the HyAB distance: that of lightness plus the Euclidean one of colour.
double distance(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = a - b;
    return std::abs(d.x) + std::hypot(d.y, d.z);
}

/// Is one of the Gaussians whose sum is the eye's sensitivity to contrast; `width` is in squared
/// degrees.
struct Blur {
    double weight;
    double width;
};

Kernel bell(const Blur& blur, int radius, double pixelsPerDegree) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) {
        const double degrees = x / pixelsPerDegree;
        kernel.push_back(
            std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / blur.width));
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

/// Holds a filtered plane before it is divided by the sum of the weights.
struct Blurred {
    std::vector<double> sum;
    double whole = 0.0; ///< is the sum of the weights
};

/// Holds the planes that filtering a picture needs.
struct Memory {
    explicit Memory(std::size_t pixels) : lightness(pixels), rows(pixels) {
        for (std::vector<double>& plane : planes) {
            plane.resize(pixels);
        }
        for (Blurred& plane : blurred) {
            plane.sum.resize(pixels);
        }
    }

    Planes planes;
    std::array<Blurred, 3> blurred;
    std::vector<double> lightness;
    std::vector<double> rows; ///< are filtered along x, not yet along y
};

using MemoryPointer = std::shared_ptr<Memory>;

void addBlur(ParallelJob& work, const MemoryPointer& memory, std::size_t plane, glm::ivec2 size,
             std::initializer_list<Blur> blurs, double pixelsPerDegree) {
    constexpr double widest = 0.04;
    const double reach = 3.0 * std::sqrt(widest / (2.0 * std::numbers::pi * std::numbers::pi));
    const int radius = static_cast<int>(std::ceil(reach * pixelsPerDegree));
    for (const Blur& blur : blurs) {
        const Kernel kernel = bell(blur, radius, pixelsPerDegree);
        const double height = blur.weight * std::sqrt(std::numbers::pi / blur.width);
        memory->blurred[plane].whole += height * sumOf(kernel) * sumOf(kernel);
        work.add(memory->rows.size(), [=](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                memory->rows[i] = filteredAlong(memory->planes[plane], size, kernel, i);
            }
        });
        work.add(memory->rows.size(), [=](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                memory->blurred[plane].sum[i] +=
                    height * filteredDown(memory->rows, size, kernel, i);
            }
        });
    }
}

/// Scales weights so that those above 0 sum up to 1, and those below to -1.
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

/// Holds the first or the second derivative of a Gaussian, and the Gaussian across it.
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

/// Adds work that computes how strong the detected feature is in each pixel, in any direction.
void addStrength(ParallelJob& work, const MemoryPointer& memory, glm::ivec2 size,
                 const Detector& detector, std::vector<double>& strength) {
    const auto addRows = [&](const Kernel& kernel) {
        work.add(memory->rows.size(), [=](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                memory->rows[i] = filteredAlong(memory->lightness, size, kernel, i);
            }
        });
    };
    addRows(detector.along);
    work.add(strength.size(), [=, &strength](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            strength[i] = filteredDown(memory->rows, size, detector.across, i);
        }
    });
    addRows(detector.across);
    work.add(strength.size(), [=, &strength](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            strength[i] =
                std::hypot(strength[i], filteredDown(memory->rows, size, detector.along, i));
        }
    });
}

void addOpponents(ParallelJob& work, const MemoryPointer& memory,
                  const std::vector<glm::dvec3>& shown) {
    work.add(shown.size(), [=, &shown](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 parts = opponent(toRelativeXyz() * srgbDecoded(shown[i]));
            for (int k = 0; k < 3; ++k) {
                memory->planes[static_cast<std::size_t>(k)][i] = parts[k];
            }
            memory->lightness[i] = (parts.x + 16.0) / 116.0;
        }
    });
}

void addColors(ParallelJob& work, const MemoryPointer& memory, std::vector<glm::dvec3>& colors) {
    work.add(colors.size(), [=, &colors](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            glm::dvec3 parts;
            for (int k = 0; k < 3; ++k) {
                const Blurred& plane = memory->blurred[static_cast<std::size_t>(k)];
                parts[k] = plane.sum[i] / plane.whole;
            }
            colors[i] = perceived(glm::clamp(lightOf(parts), 0.0, 1.0));
        }
    });
}

} // namespace

Flip::Flip(glm::ivec2 size, double pixelsPerDegree)
    : size_(size), pixelsPerDegree_(pixelsPerDegree),
      farthest_(
          std::pow(distance(perceived({0.0, 1.0, 0.0}), perceived({0.0, 0.0, 1.0})), colorPower)) {}

Flip::Flip(glm::ivec2 size, const std::vector<glm::dvec3>& right, ParallelJob& work,
           double pixelsPerDegree)
    : Flip(size, pixelsPerDegree) {
    addSeeing(work, right, reference_);
}

Flip::Flip(glm::ivec2 size, const std::vector<glm::dvec3>& right, double pixelsPerDegree)
    : Flip(size, pixelsPerDegree) {
    ParallelJob work;
    addSeeing(work, right, reference_);
    work.finish();
}

void Flip::addSeeing(ParallelJob& work, const std::vector<glm::dvec3>& shown, Seen& seen) const {
    seen.colors.resize(shown.size());
    seen.edges.resize(shown.size());
    seen.points.resize(shown.size());
    const auto memory = std::make_shared<Memory>(shown.size());
    const double degree = pixelsPerDegree_;
    addOpponents(work, memory, shown);
    addBlur(work, memory, 0, size_, {{1.0, 0.0047}}, degree);
    addBlur(work, memory, 1, size_, {{1.0, 0.0053}}, degree);
    addBlur(work, memory, 2, size_, {{34.1, 0.04}, {13.5, 0.025}}, degree);
    addColors(work, memory, seen.colors);
    addStrength(work, memory, size_, detector(false, degree), seen.edges);
    addStrength(work, memory, size_, detector(true, degree), seen.points);
}

std::vector<double> Flip::differences(const std::vector<glm::dvec3>& shown) const {
    ParallelJob work;
    std::vector<double> map;
    addDifferences(work, shown, map);
    work.finish();
    return map;
}

void Flip::addDifferences(ParallelJob& work, const std::vector<glm::dvec3>& shown,
                          std::vector<double>& map) const {
    map.resize(shown.size());
    const auto other = std::make_shared<Seen>();
    addSeeing(work, shown, *other);
    work.add(map.size(), [this, other, &map](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            map[i] = difference(*other, i);
        }
    });
}

double Flip::difference(const Seen& other, std::size_t pixel) const {
    const double apart =
        std::pow(distance(reference_.colors[pixel], other.colors[pixel]), colorPower);
    const double limit = nearShare * farthest_;
    const double color =
        apart < limit ? nearScale * apart / limit
                      : nearScale + (1.0 - nearScale) * (apart - limit) / (farthest_ - limit);
    const double feature = std::max(std::abs(reference_.edges[pixel] - other.edges[pixel]),
                                    std::abs(reference_.points[pixel] - other.points[pixel]));
    const double share = std::pow(std::numbers::sqrt2 / 2.0 * feature, featurePower);
    return std::pow(color, 1.0 - share);
}

} // namespace patina
