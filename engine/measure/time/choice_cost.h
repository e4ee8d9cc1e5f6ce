// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "measure/time/median_interval.h"

namespace patina {

/// Frames without anything to shade, of which the median counts, and its interval as the noise: so
/// many that three at each end do not.
constexpr int emptyFrames = 15;

/// Holds what a way to compute a frame takes beside the exact one.
struct ChoiceCost {
    MedianInterval ratio{1.0, 1.0, 1.0}; ///< to the exact time, both without the empty frame's
    MedianInterval milliseconds;         ///< of the whole frame: by the ratio, from the exact one's
    double nanosecondsPerPixel = 0.0;    ///< per shaded pixel, without the empty frame's time
    int runs = 0;                        ///< pairs of frames
    bool settled = false;                ///< the ratio's interval is as narrow as was wanted
    /// There are pairs enough for an interval of 95 %, or the time is given, not measured.
    bool isSure() const { return haveInterval(runs); }
    /// Most frames take no longer than one without anything to shade, as far as can be told: the
    /// time is at most what the ratio says.
    bool belowNoise = false;

    friend bool operator==(const ChoiceCost&, const ChoiceCost&) = default;
};

/// Tells what a ratio of two times says where one of them, or both, cannot be told from none.
enum class RatioBound { None, AtMost, AtLeast, Unknown };

/// Says whether the ratio of `cost` to `from`, or to the bound of that, is a bound itself.
RatioBound boundOf(const ChoiceCost& cost, const ChoiceCost& from);

/// Pairs of frames that follow each other, one exact and one not, so that whatever else the machine
/// does meets both alike. Taken until the 95 % interval of the ratio of their times is narrow.
class CostPairs {
  public:
    struct Options {
        double width = 0.03; ///< of the interval, relative to the ratio
        int min = 7;         ///< an interval of 95 % needs 6 samples
        int max = 60;        ///< pairs, settled or not
    };

    /// `empty`: milliseconds of the frame without what is shaded.
    CostPairs(const Options& options, const MedianInterval& empty)
        : options_(options), empty_(empty) {}

    /// Takes in the milliseconds of a pair.
    void add(double exact, double other);
    bool finished() const;
    int runs() const { return static_cast<int>(ratios_.size()); } ///< pairs

    /// Returns the cost without times: see withTimes().
    ChoiceCost cost() const;

  private:
    bool isSettled(const MedianInterval& ratio) const;

    Options options_;
    MedianInterval empty_;
    std::vector<double> ratios_;
    int belowNoise_ = 0;      ///< of the ratios
    int exactBelowNoise_ = 0; ///< of the ratios, those to a bound
};

/// Holds the frame that ratios count from.
struct ExactFrame {
    double milliseconds = 0.0; ///< of the exact frame
    MedianInterval empty;      ///< milliseconds of one of which nothing is shaded
    std::size_t pixels = 0;    ///< that are shaded
};

/// Returns the cost with the times that its ratio means, so that the times of a chart go together
/// although the machine was faster at one time than at another.
ChoiceCost withTimes(ChoiceCost cost, const ExactFrame& exact);

} // namespace patina
