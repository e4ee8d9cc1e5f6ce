// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/structural_similarity.h"

#include <cmath>

#include "measure/error/parallel.h"
#include "measure/error/plane_filter.h"

namespace patina {
namespace {

constexpr int radius = 5; ///< pixels, of a window of 11 x 11
constexpr double deviation = 1.5;
constexpr double c1 = 0.01 * 0.01;
constexpr double c2 = 0.03 * 0.03;

Kernel window() {
    Kernel kernel;
    double sum = 0.0;
    for (int x = -radius; x <= radius; ++x) {
        kernel.push_back(std::exp(-x * x / (2.0 * deviation * deviation)));
        sum += kernel.back();
    }
    for (double& weight : kernel) {
        weight /= sum;
    }
    return kernel;
}

using Plane = std::vector<double>;

/// Returns the weighted mean of the window around each pixel.
Plane means(const Plane& plane, glm::ivec2 size, const Kernel& kernel) {
    Plane rows(plane.size());
    Plane result(plane.size());
    inParallel(plane.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            rows[i] = filteredAlong(plane, size, kernel, i);
        }
    });
    inParallel(plane.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            result[i] = filteredDown(rows, size, kernel, i);
        }
    });
    return result;
}

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        result[i] = a[i] * b[i];
    }
    return result;
}

} // namespace

double structuralSimilarity(glm::ivec2 size, const Plane& a, const Plane& b) {
    const Kernel kernel = window();
    const Plane meanA = means(a, size, kernel);
    const Plane meanB = means(b, size, kernel);
    const Plane squareA = means(product(a, a), size, kernel);
    const Plane squareB = means(product(b, b), size, kernel);
    const Plane both = means(product(a, b), size, kernel);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double ab = meanA[i] * meanB[i];
        const double aa = meanA[i] * meanA[i];
        const double bb = meanB[i] * meanB[i];
        const double luminance = (2.0 * ab + c1) / (aa + bb + c1);
        const double structure =
            (2.0 * (both[i] - ab) + c2) / (squareA[i] - aa + squareB[i] - bb + c2);
        sum += luminance * structure;
    }
    return a.empty() ? 1.0 : sum / double(a.size());
}

} // namespace patina
