// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/picture_distance.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <numeric>

#include <glm/geometric.hpp>

#include "measure/error/flip.h"
#include "measure/error/structural_similarity.h"

namespace patina {
namespace {

constexpr std::chrono::milliseconds workSlice{20};
constexpr glm::dvec3 luma{0.2126, 0.7152, 0.0722}; ///< ITU-R BT.709

std::vector<double> greysOf(const std::vector<glm::dvec3>& colors) {
    std::vector<double> greys(colors.size());
    std::ranges::transform(colors, greys.begin(),
                           [](const glm::dvec3& color) { return glm::dot(luma, color); });
    return greys;
}

double meanOf(const auto& values) {
    return values.empty()
               ? 0.0
               : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

} // namespace

std::vector<glm::dvec3> displayColors(const Image& image) {
    const auto channels = std::size_t(image.channels);
    std::vector<glm::dvec3> colors(image.pixels.size() / channels);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const float* pixel = image.pixels.data() + channels * i;
        colors[i] = {pixel[0], pixel[1], pixel[2]};
    }
    return colors;
}

std::optional<PictureDistance> pictureDistance(std::vector<float> relative, const Image& a,
                                               const Image& b,
                                               const std::function<bool()>& isNeedless) {
    assert(a.channels >= 3 && a.width == b.width && a.height == b.height);
    assert(relative.size() == std::size_t(a.width) * std::size_t(a.height));
    const std::vector<glm::dvec3> right = displayColors(a);
    const std::vector<glm::dvec3> other = displayColors(b);
    const glm::ivec2 size{a.width, a.height};
    ParallelJob work;
    const Flip flip(size, right, work);
    std::vector<double> map;
    flip.addDifferences(work, other, map);
    while (!work.step(workSlice)) {
        if (isNeedless()) {
            return std::nullopt;
        }
    }
    PictureDistance distance;
    distance.flip = meanOf(map);
    distance.similarity = structuralSimilarity(size, greysOf(right), greysOf(other));
    if (!relative.empty()) {
        distance.mean = meanOf(relative);
        const auto at = relative.begin() + std::ptrdiff_t(99 * (relative.size() - 1) / 100);
        std::ranges::nth_element(relative, at);
        distance.percentile99 = *at;
        distance.largest = *std::max_element(at, relative.end());
    }
    return distance;
}

} // namespace patina
