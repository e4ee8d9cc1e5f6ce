// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/warp_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace patina {
namespace {

struct Interval {
    std::size_t low = 0;
    std::size_t high = 0;
    double share = 0.0; ///< 0 .. 1, of `high`
};

Interval intervalOf(const std::vector<float>& values, double x) {
    if (values.size() < 2 || !(x > double(values.front()))) {
        return {};
    }
    const auto above = std::ranges::upper_bound(values, float(x));
    const auto high = std::min(static_cast<std::size_t>(above - values.begin()), values.size() - 1);
    const double width = double(values[high]) - double(values[high - 1]);
    const double share = (x - double(values[high - 1])) / width;
    return {high - 1, high, std::clamp(share, 0.0, 1.0)};
}

/// Is a cell of a grid and the place in it, 0 .. 1.
struct Cell {
    std::size_t index = 0;
    double place = 0.0;
};

Cell cellOf(double unit, int points) {
    const double scaled = std::clamp(unit, 0.0, 1.0) * double(points - 1);
    const double index = std::min(std::floor(scaled), double(points - 2));
    return {static_cast<std::size_t>(index), scaled - index};
}

/// Returns the integral from 0 to x of what goes linearly from a to b.
double partOf(double a, double b, double x) {
    return x * (a + 0.5 * x * (b - a));
}

/// Returns the x in 0 .. 1 at which that integral is `part`.
double placeOfPart(double a, double b, double part) {
    if (!(a + b > 0.0)) {
        return 0.0;
    }
    // The root in the form that loses nothing where a and b are nearly equal.
    const double root = std::sqrt(std::max(a * a + 2.0 * part * (b - a), 0.0));
    return std::clamp(2.0 * part / (a + root), 0.0, 1.0);
}

} // namespace

SquareTable::SquareTable(std::vector<float> values, glm::ivec2 columnsAndRows,
                         std::vector<float> first, std::vector<float> second)
    : values_(std::move(values)), size_(columnsAndRows), first_(std::move(first)),
      second_(std::move(second)) {}

SquareTable::Slices SquareTable::slicesAt(double first, double second) const {
    const Interval a = intervalOf(first_, first);
    const Interval b = intervalOf(second_, second);
    const std::size_t row = second_.size();
    return {
        {a.low * row + b.low, a.low * row + b.high, a.high * row + b.low, a.high * row + b.high},
        {(1.0 - a.share) * (1.0 - b.share), (1.0 - a.share) * b.share, a.share * (1.0 - b.share),
         a.share * b.share}};
}

double SquareTable::weighted(const std::vector<float>& numbers, std::size_t stride,
                             std::size_t index, const Slices& slices) {
    double sum = 0.0;
    for (std::size_t i = 0; i < slices.index.size(); ++i) {
        if (slices.weight[i] > 0.0) {
            sum += slices.weight[i] * double(numbers[slices.index[i] * stride + index]);
        }
    }
    return sum;
}

double SquareTable::at(glm::dvec2 place, const Slices& slices) const {
    const Cell x = cellOf(place.x, size_.x);
    const Cell y = cellOf(place.y, size_.y);
    const auto columns = static_cast<std::size_t>(size_.x);
    const std::size_t corner = y.index * columns + x.index;
    const auto point = [&](std::size_t offset) {
        return weighted(values_, sliceSize(), corner + offset, slices);
    };
    return (1.0 - y.place) * ((1.0 - x.place) * point(0) + x.place * point(1)) +
           y.place * ((1.0 - x.place) * point(columns) + x.place * point(columns + 1));
}

WarpTable::WarpTable(SquareTable density)
    : density_(std::move(density)), rows_(density_.slices() * density_.sliceSize()),
      marginal_(density_.slices() * static_cast<std::size_t>(density_.size().y)) {
    const auto columns = static_cast<std::size_t>(density_.size().x);
    const auto rows = static_cast<std::size_t>(density_.size().y);
    for (std::size_t slice = 0; slice < density_.slices(); ++slice) {
        const std::size_t start = slice * density_.sliceSize();
        std::vector<double> sums(rows);
        std::vector<double> along(columns * rows);
        for (std::size_t y = 0; y < rows; ++y) {
            for (std::size_t x = 0; x + 1 < columns; ++x) {
                const std::size_t i = y * columns + x;
                along[i + 1] = along[i] + 0.5 * (double(density_.value(start + i)) +
                                                 double(density_.value(start + i + 1)));
            }
            sums[y] = along[y * columns + columns - 1];
        }
        std::vector<double> marginal(rows);
        for (std::size_t y = 0; y + 1 < rows; ++y) {
            marginal[y + 1] = marginal[y] + 0.5 * (sums[y] + sums[y + 1]);
        }
        const double scale = marginal.back() > 0.0 ? 1.0 / marginal.back() : 0.0;
        for (std::size_t i = 0; i < along.size(); ++i) {
            rows_[start + i] = float(along[i] * scale);
            density_.value(start + i) = float(double(density_.value(start + i)) * scale);
        }
        for (std::size_t y = 0; y < rows; ++y) {
            marginal_[slice * rows + y] = float(marginal[y] * scale);
        }
    }
}

glm::dvec2 WarpTable::inverse(glm::dvec2 place, const SquareTable::Slices& slices) const {
    const Cell x = cellOf(place.x, density_.size().x);
    const Cell y = cellOf(place.y, density_.size().y);
    const auto columns = static_cast<std::size_t>(density_.size().x);
    const auto rows = static_cast<std::size_t>(density_.size().y);
    const auto atRow = [&](std::size_t row, std::size_t column) {
        return SquareTable::weighted(rows_, density_.sliceSize(), row * columns + column, slices);
    };
    const auto densityAt = [&](std::size_t row, std::size_t column) {
        const glm::dvec2 point(double(column) / double(columns - 1),
                               double(row) / double(rows - 1));
        return density_.at(point, slices);
    };
    const double share = y.place;
    const auto blended = [&](const auto& function, std::size_t column) {
        return (1.0 - share) * function(y.index, column) + share * function(y.index + 1, column);
    };
    const double row = blended(atRow, columns - 1);
    const double along = blended(atRow, x.index) + partOf(blended(densityAt, x.index),
                                                          blended(densityAt, x.index + 1), x.place);
    const double up = SquareTable::weighted(marginal_, rows, y.index, slices) +
                      partOf(atRow(y.index, columns - 1), atRow(y.index + 1, columns - 1), share);
    return {row > 0.0 ? std::min(along / row, 1.0) : 0.0, std::min(up, 1.0)};
}

glm::dvec2 WarpTable::forward(glm::dvec2 uniform, const SquareTable::Slices& slices) const {
    const auto columns = static_cast<std::size_t>(density_.size().x);
    const auto rows = static_cast<std::size_t>(density_.size().y);
    const auto marginalAt = [&](std::size_t row) {
        return SquareTable::weighted(marginal_, rows, row, slices);
    };
    std::size_t row = 0;
    while (row + 2 < rows && marginalAt(row + 1) < uniform.y) {
        ++row;
    }
    const auto rowAt = [&](std::size_t index, std::size_t column) {
        return SquareTable::weighted(rows_, density_.sliceSize(), index * columns + column, slices);
    };
    const double y = placeOfPart(rowAt(row, columns - 1), rowAt(row + 1, columns - 1),
                                 uniform.y - marginalAt(row));
    const auto along = [&](std::size_t column) {
        return (1.0 - y) * rowAt(row, column) + y * rowAt(row + 1, column);
    };
    const double wanted = uniform.x * along(columns - 1);
    std::size_t column = 0;
    while (column + 2 < columns && along(column + 1) < wanted) {
        ++column;
    }
    const double up = (double(row) + y) / double(rows - 1);
    const auto densityAt = [&](std::size_t index) {
        return density_.at({double(index) / double(columns - 1), up}, slices);
    };
    const double x = placeOfPart(densityAt(column), densityAt(column + 1), wanted - along(column));
    return {(double(column) + x) / double(columns - 1), up};
}

} // namespace patina
