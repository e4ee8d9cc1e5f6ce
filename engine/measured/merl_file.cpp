// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/merl_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "measured/byte_reader.h"
#include "measured/half_difference.h"
#include "measured/sampled_table.h"

namespace patina {
namespace {

using std::numbers::pi;

/// Turns a file's number into 1/sr, per channel.
constexpr std::array<double, 3> unit{1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

constexpr std::size_t headerBytes = 3 * sizeof(std::int32_t);
constexpr std::size_t maxBins = std::size_t(1) << 25;

/// Is a place between two bins of an axis.
struct Between {
    std::size_t low = 0;
    std::size_t high = 0;
    double share = 0.0; ///< 0 .. 1, of `high`
};

/// Returns the bins around a place that is counted in bins from the axis' start.
Between between(double place, std::size_t bins, bool isRing) {
    const double middle = place - 0.5; // values belong to the middle of a bin
    const double floor = std::floor(middle);
    const double last = double(bins) - 1.0;
    if (isRing) {
        const auto low = static_cast<std::size_t>(floor < 0.0 ? last : std::min(floor, last));
        return {low, (low + 1) % bins, middle - floor};
    }
    const auto low = static_cast<std::size_t>(std::clamp(floor, 0.0, last));
    return {low, std::min(low + 1, bins - 1), floor < 0.0 ? 0.0 : middle - floor};
}

class MerlReflectance : public MeasuredReflectance {
  public:
    MerlReflectance(const std::array<std::size_t, 3>& bins, std::vector<float> values)
        : bins_(bins), values_(std::move(values)) {}

    glm::dvec3 evaluate(const DirectionPair& pair) const override {
        if (!(pair.l.z > 0.0 && pair.v.z > 0.0)) {
            return glm::dvec3(0.0);
        }
        const HalfDifference angles = halfDifference(pair);
        return mean(between(halfPlace(angles.half), bins_[0], false),
                    between(differencePlace(angles.difference), bins_[1], false),
                    between(azimuthPlace(angles.azimuth), bins_[2], true));
    }

    std::optional<DirectionPair> nearestSample(const DirectionPair& pair) const override {
        const HalfDifference angles = halfDifference(pair);
        const std::size_t bin = (binAt(halfPlace(angles.half), bins_[0]) * bins_[1] +
                                 binAt(differencePlace(angles.difference), bins_[1])) *
                                    bins_[2] +
                                binAt(azimuthPlace(angles.azimuth), bins_[2]);
        const DirectionPair middle = directionsAt(middleOf(bin));
        return isMeasured(bin) && middle.l.z > 0.0 && middle.v.z > 0.0 ? std::optional(middle)
                                                                       : std::nullopt;
    }

    HalfDifferenceTable table(TableForm form) const override {
        if (form == TableForm::WithGrain) {
            return sampledTable(*this, form);
        }
        HalfDifferenceTable table;
        table.bins = {int(bins_[2]), int(bins_[1]), int(bins_[0])};
        table.texels.resize(count());
        for (std::size_t bin = 0; bin < count(); ++bin) {
            table.texels[bin] = {values_[bin], values_[bin + count()], values_[bin + 2 * count()]};
        }
        return table;
    }

    bool isIsotropic() const override { return true; }

    std::string description() const override {
        return fmt::format("MERL, {} x {} x {}", bins_[0], bins_[1], bins_[2]);
    }

  private:
    std::size_t count() const { return bins_[0] * bins_[1] * bins_[2]; }
    bool isMeasured(std::size_t bin) const { return values_[bin] >= 0.0f; }

    /// Are places along the axes for angles in radians, in bins from the start.
    double halfPlace(double half) const { return std::sqrt(half / (0.5 * pi)) * double(bins_[0]); }
    double differencePlace(double angle) const { return angle / (0.5 * pi) * double(bins_[1]); }
    double azimuthPlace(double azimuth) const { return azimuth / pi * double(bins_[2]); }

    static std::size_t binAt(double place, std::size_t bins) {
        return std::min(static_cast<std::size_t>(place), bins - 1);
    }

    HalfDifference middleOf(std::size_t bin) const {
        const std::size_t row = bin / bins_[2];
        const std::size_t layer = row / bins_[1];
        const double third = double(bin % bins_[2]) + 0.5;
        const double second = double(row % bins_[1]) + 0.5;
        const double first = (double(layer) + 0.5) / double(bins_[0]);
        return {first * first * 0.5 * pi, second / double(bins_[1]) * 0.5 * pi,
                third / double(bins_[2]) * pi};
    }

    /// Returns the mean of the measured ones of the eight bins around, by their shares.
    glm::dvec3 mean(const Between& half, const Between& difference, const Between& azimuth) const {
        glm::dvec3 sum(0.0);
        double weights = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const auto [i, a] = side(half, (corner & 1) != 0);
            const auto [j, b] = side(difference, (corner & 2) != 0);
            const auto [k, c] = side(azimuth, (corner & 4) != 0);
            const std::size_t bin = (i * bins_[1] + j) * bins_[2] + k;
            const double weight = a * b * c;
            if (weight > 0.0 && isMeasured(bin)) {
                sum += weight *
                       glm::dvec3(values_[bin], values_[bin + count()], values_[bin + 2 * count()]);
                weights += weight;
            }
        }
        return weights > 0.0 ? glm::max(sum / weights, glm::dvec3(0.0)) : glm::dvec3(0.0);
    }

    static std::pair<std::size_t, double> side(const Between& place, bool isHigh) {
        return isHigh ? std::pair(place.high, place.share)
                      : std::pair(place.low, 1.0 - place.share);
    }

    std::array<std::size_t, 3> bins_;
    std::vector<float> values_; ///< are in 1/sr: all of red, of green, of blue
};

/// Tells whether all bytes are printed characters or white space of ASCII.
bool isText(std::string_view bytes) {
    return std::ranges::all_of(
        bytes, [](char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); });
}

Result<std::array<std::size_t, 3>> binsOf(std::string_view bytes) {
    ByteReader reader(bytes);
    std::array<std::size_t, 3> bins{};
    std::size_t product = 1;
    for (std::size_t& count : bins) {
        const auto number = reader.next<std::int32_t>();
        if (!number) {
            return failure(
                fmt::format("byte {}: the file ends in its numbers of bins", bytes.size()),
                "a MERL or RGL file");
        }
        if (product == 1 && isText(bytes.substr(0, headerBytes))) {
            return failure("byte 0: the file begins with text, not with numbers of bins",
                           "a MERL or RGL file");
        }
        if (*number < 1 || std::size_t(*number) > maxBins / product) {
            return failure(fmt::format("byte {}: {} is no number of bins",
                                       reader.place() - sizeof(std::int32_t), *number),
                           "a MERL or RGL file");
        }
        count = std::size_t(*number);
        product *= count;
    }
    const std::size_t wanted = headerBytes + 3 * product * sizeof(double);
    if (bytes.size() != wanted) {
        return failure(bytes.size() < wanted
                           ? fmt::format("byte {}: the file ends too early", bytes.size())
                           : fmt::format("byte {}: the file goes on behind its last value", wanted),
                       fmt::format("{} bytes for {} x {} x {} values of three colours", wanted,
                                   bins[0], bins[1], bins[2]));
    }
    return bins;
}

} // namespace

Result<std::shared_ptr<const MeasuredReflectance>> merlReflectance(std::string_view bytes) {
    const auto bins = binsOf(bytes);
    if (!bins) {
        return tl::unexpected(bins.error());
    }
    const std::size_t count = (*bins)[0] * (*bins)[1] * (*bins)[2];
    std::vector<float> values;
    values.reserve(3 * count);
    ByteReader reader(bytes, headerBytes);
    bool isEmpty = true;
    while (const auto number = reader.next<double>()) {
        const double value = *number * unit[values.size() / count];
        if (!std::isfinite(value) || std::abs(value) > std::numeric_limits<float>::max()) {
            return failure(fmt::format("byte {}: {} is no reflectance",
                                       reader.place() - sizeof(double), *number),
                           "a finite number");
        }
        values.push_back(float(value));
        isEmpty = isEmpty && value < 0.0;
    }
    if (isEmpty) {
        return failure("holds no measured value");
    }
    return std::make_shared<const MerlReflectance>(*bins, std::move(values));
}

} // namespace patina
