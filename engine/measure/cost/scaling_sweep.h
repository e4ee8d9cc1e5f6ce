// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "measure/cost/cost_sweep.h"
#include "measure/cost/scaling_curve.h"

namespace patina {

/// Measures how the time of a frame grows with the pixels of the picture, with the lights and with
/// the objects, each by itself. Works in steps, round after round over all counts of an axis, so
/// that whatever else the machine does meets all of them alike. Made, used and destroyed with one
/// context current.
class ScalingSweep {
  public:
    struct Options {
        std::vector<int> edges{}; ///< of square pictures, pixels; empty: what the device is up to
        std::vector<int> lights{1, 2, 4, 8, 16, 32};
        std::vector<int> objects{1, 4, 16, 64, 256};
        int edge = 256; ///< of the picture with more lights or objects
        int rounds = 7; ///< an interval of 95 % needs 6 samples
        /// After a third of that no further round over an axis is begun.
        double seconds = std::numeric_limits<double>::infinity();
        std::filesystem::path programCache{};
    };

    static Result<std::unique_ptr<ScalingSweep>> create(CostSweep::Subject subject,
                                                        Options options);
    static Result<std::unique_ptr<ScalingSweep>> create(CostSweep::Subject subject);
    ~ScalingSweep();

    /// Times one frame, or two where the first only warms up.
    void step();
    bool finished() const;
    double progress() const; ///< 0 .. 1

    /// Says which axis is measured now, and how often it was.
    struct Turn {
        ScalingCurve::Axis axis = ScalingCurve::Axis::Pixels;
        std::size_t number = 1; ///< of the axis, from 1 on
        std::size_t of = 1;
        int round = 0; ///< 0 makes programs
        int rounds = 1;
    };
    Turn turn() const;

    /// Returns what the rounds that are done gave; an axis appears with its first one.
    const std::vector<ScalingCurve>& curves() const;

    /// Grows whenever the curves have more to say.
    int rounds() const;

    std::string timer() const;
    const Errors& problems() const;

  private:
    class Implementation;
    explicit ScalingSweep(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
