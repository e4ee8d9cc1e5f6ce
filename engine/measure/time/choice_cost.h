// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "measure/time/median_interval.h"

namespace patina {

/// Is the number of frames without anything to shade that are timed. Their median is subtracted,
/// and its interval is the noise: of so many, three at each end are left out.
constexpr int emptyFrames = 15;

/// Holds the time of a frame with some levels, compared with that of the exact frame.
struct ChoiceCost {
    MedianInterval ratio{1.0, 1.0, 1.0}; ///< is to the exact time, both without the empty frame's
    MedianInterval milliseconds;         ///< is the whole frame's: the ratio times the exact one's
    double nanosecondsPerPixel = 0.0;    ///< is per shaded pixel, without the empty frame's time
    int runs = 0;         ///< counts pairs of frames; 0: times are given, not measured
    bool settled = false; ///< says that the ratio's interval is as narrow as wanted
    /// Tells whether there are pairs enough for an interval of 95 %, or the time is given.
    bool isSure() const { return haveInterval(runs); }
    /// Tells whether the time is given, as a predicted one is: then it has no noise.
    bool isGiven() const { return runs == 0; }
    /// Says that most frames cannot be told from one without anything to shade: the time is at most
    /// what the ratio says.
    bool belowNoise = false;

    friend bool operator==(const ChoiceCost&, const ChoiceCost&) = default;
};

/// Tells whether a ratio of two times is only a bound, since one or both are below the noise.
enum class RatioBound { None, AtMost, AtLeast, Unknown };

/// Says whether the ratio of `cost` to `from`, or to the bound of that, is a bound itself.
RatioBound boundOf(const ChoiceCost& cost, const ChoiceCost& from);

/// Collects the times of pairs of consecutive frames, one exact and one not, so that other load of
/// the machine affects both alike. It is finished when the 95 % interval of their ratio is narrow.
class CostPairs {
  public:
    struct Options {
        double width = 0.03; ///< is that of the interval, relative to the ratio
        int min = 7;         ///< pairs at least; an interval of 95 % needs 6
        int max = 60;        ///< pairs at most, settled or not
    };

    /// Takes the milliseconds of a frame without anything to shade as `empty`.
    CostPairs(const Options& options, const MedianInterval& empty)
        : options_(options), empty_(empty) {}

    /// Adds the milliseconds of a pair.
    void add(double exact, double other);
    bool finished() const;
    int runs() const { return static_cast<int>(ratios_.size()); } ///< pairs

    /// Returns the cost without times, which withTimes() adds.
    ChoiceCost cost() const;

  private:
    bool isSettled(const MedianInterval& ratio) const;

    Options options_;
    MedianInterval empty_;
    std::vector<double> ratios_;
    int belowNoise_ = 0;      ///< counts ratios whose other frame is below the noise
    int exactBelowNoise_ = 0; ///< counts ratios whose exact frame is below the noise
};

/// Describes the exact frame, to which ratios refer.
struct ExactFrame {
    double milliseconds = 0.0;
    MedianInterval empty;   ///< milliseconds of a frame without anything to shade
    std::size_t pixels = 0; ///< counts the shaded ones
};

/// Returns the cost with times computed from its ratio, so that the times of a chart are consistent
/// although the machine's speed varied.
ChoiceCost withTimes(ChoiceCost cost, const ExactFrame& exact);

} // namespace patina
