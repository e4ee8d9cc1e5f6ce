// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/color.h"

namespace patina {
namespace {

constexpr double evenShare = 0.01;

double finiteLuminance(const glm::vec4& color) {
    const double sum = luminance(glm::dvec3(color));
    return std::isfinite(sum) ? std::max(sum, 0.0) : 0.0;
}

/// Writes the cumulative distribution of `weights` into the red of `out`; the last number is
/// exactly 1.
void accumulate(std::span<const double> weights, std::span<glm::vec2> out) {
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i];
        out[i].x = static_cast<float>(sum / all);
    }
    out[weights.size() - 1].x = 1.0f;
}

/// Returns the squared sine of the angle from straight up to the upper edge of a row; 1 below the
/// horizon.
double heightAbove(double row, int rows) {
    const double sine = std::sin(std::numbers::pi * std::min(row / double(rows), 0.5));
    return sine * sine;
}

double shareOf(std::span<const glm::vec2> running, std::size_t i) {
    return double(running[i].x) - (i > 0 ? double(running[i - 1].x) : 0.0);
}

} // namespace

glm::ivec2 EnvironmentTable::textureSize() const {
    return {std::max(size_.x, size_.y), size_.y + 1};
}

void EnvironmentTable::build(glm::ivec2 size, std::span<const glm::vec4> radiance) {
    size_ = size;
    const auto columns = static_cast<std::size_t>(size.x);
    const auto rows = static_cast<std::size_t>(size.y);
    weights_.assign(columns * rows, 0.0);
    rows_.assign(rows, 0.0);
    const glm::ivec2 texture = textureSize();
    texels_.assign(std::size_t(texture.x) * std::size_t(texture.y), glm::vec2(0.0f));
    const double mean = weigh(radiance) / double(columns * rows);
    const double even = mean > 0.0 ? evenShare * mean : 1.0;
    for (std::size_t row = 0; row < rows; ++row) {
        const double height = std::sin(std::numbers::pi * (double(row) + 0.5) / double(rows));
        for (std::size_t column = 0; column < columns; ++column) {
            double& weight = weights_[row * columns + column];
            weight = height * (weight + even);
            rows_[row] += weight;
        }
        fillRow(static_cast<int>(row));
    }
    accumulate(rows_, std::span(texels_).subspan(rows * std::size_t(texture.x), rows));
    fillDensities();
    gatherUpward(radiance);
}

/// Computes upward(). Under uniform light, the directions between the angles a and b from straight
/// up give the share sin^2 b - sin^2 a of the light on the surface.
void EnvironmentTable::gatherUpward(std::span<const glm::vec4> radiance) {
    upward_ = glm::dvec3(0.0);
    const std::size_t count = std::min(weights_.size(), radiance.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t row = i / std::size_t(size_.x);
        upward_ += (heightAbove(double(row) + 1.0, size_.y) - heightAbove(double(row), size_.y)) *
                   glm::dvec3(radiance[i]);
    }
    upward_ /= double(size_.x);
}

/// Fills weights_ with luminances and returns their sum.
double EnvironmentTable::weigh(std::span<const glm::vec4> radiance) {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min(weights_.size(), radiance.size()); ++i) {
        weights_[i] = finiteLuminance(radiance[i]);
        sum += weights_[i];
    }
    return sum;
}

void EnvironmentTable::fillRow(int row) {
    const auto columns = static_cast<std::size_t>(size_.x);
    const auto first = static_cast<std::size_t>(row);
    accumulate(std::span(weights_).subspan(first * columns, columns),
               std::span(texels_).subspan(first * std::size_t(textureSize().x), columns));
}

void EnvironmentTable::fillDensities() {
    const auto columns = static_cast<std::size_t>(size_.x);
    const auto rows = static_cast<std::size_t>(size_.y);
    const auto stride = static_cast<std::size_t>(textureSize().x);
    const std::span<const glm::vec2> all(texels_);
    for (std::size_t row = 0; row < rows; ++row) {
        const double share = shareOf(all.subspan(rows * stride, rows), row) * double(rows);
        for (std::size_t column = 0; column < columns; ++column) {
            texels_[row * stride + column].y = static_cast<float>(
                share * shareOf(all.subspan(row * stride, columns), column) * double(columns));
        }
    }
}

} // namespace patina
