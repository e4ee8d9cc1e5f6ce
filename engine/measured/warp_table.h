// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Holds functions over the unit square, given at the points of a grid and bilinear between, one
/// for each pair of values of two parameters; between those they are interpolated linearly.
class SquareTable {
  public:
    /// Places a pair of parameters between the nearest slices.
    struct Slices {
        std::array<std::size_t, 4> index{};
        std::array<double, 4> weight{1.0, 0.0, 0.0, 0.0};
    };

    /// `values` has the numbers of all slices: first parameter, second parameter, row, column, the
    /// last quickest. `first` and `second` are the parameters' values, rising; a single one counts
    /// for all. Columns and rows are at least 2.
    SquareTable(std::vector<float> values, glm::ivec2 columnsAndRows, std::vector<float> first,
                std::vector<float> second);

    Slices slicesAt(double first, double second) const;

    /// Returns the value at a place of the unit square.
    double at(glm::dvec2 place, const Slices& slices) const;

    glm::ivec2 size() const { return size_; }
    const std::vector<float>& first() const { return first_; }
    const std::vector<float>& second() const { return second_; }
    std::size_t sliceSize() const { return std::size_t(size_.x) * std::size_t(size_.y); }
    std::size_t slices() const { return values_.size() / sliceSize(); }
    float& value(std::size_t index) { return values_[index]; }
    float value(std::size_t index) const { return values_[index]; }

    /// Returns a number of an array with one per slice and grid point, weighted.
    static double weighted(const std::vector<float>& numbers, std::size_t stride, std::size_t index,
                           const Slices& slices);

  private:
    std::vector<float> values_;
    glm::ivec2 size_;
    std::vector<float> first_;
    std::vector<float> second_;
};

/// Maps the unit square to itself so that uniform points become points with the density of a table,
/// and back. Each slice is scaled to integrate to 1.
class WarpTable {
  public:
    explicit WarpTable(SquareTable density);

    const SquareTable& density() const { return density_; }

    /// Returns the uniform point that becomes `place`.
    glm::dvec2 inverse(glm::dvec2 place, const SquareTable::Slices& slices) const;

    /// Returns what a uniform point becomes.
    glm::dvec2 forward(glm::dvec2 uniform, const SquareTable::Slices& slices) const;

  private:
    SquareTable density_;
    std::vector<float> rows_;     ///< is the integral over each row from its start to each column
    std::vector<float> marginal_; ///< is the integral from the first row to each
};

} // namespace patina
