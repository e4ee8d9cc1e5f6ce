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
/// the objects, each by itself. It works in steps, round after round over all counts of an axis, so
/// that other load of the machine affects all of them alike. It must be made, used and destroyed
/// with the same context current.
class ScalingSweep {
  public:
    struct Options {
        std::vector<int> edges{}; ///< pixels, of square pictures; empty: as the device allows
        std::vector<int> lights{1, 2, 4, 8, 16, 32};
        std::vector<int> objects{1, 4, 16, 64, 256};
        int edge = 256; ///< pixels, of the square picture with more lights or objects
        int rounds = 7; ///< is at least 6 for an interval of 95 %
        /// Limits the time: after a third of it no further round over an axis is begun.
        double seconds = std::numeric_limits<double>::infinity();
        std::filesystem::path programCache{};
    };

    static Result<std::unique_ptr<ScalingSweep>> create(CostSweep::Subject subject,
                                                        Options options);
    static Result<std::unique_ptr<ScalingSweep>> create(CostSweep::Subject subject);
    ~ScalingSweep();

    /// Times one frame, after another one of the same size where the size changes.
    void step();
    bool finished() const;
    double progress() const; ///< 0 .. 1

    /// Says which axis is measured now, and in which round.
    struct Turn {
        ScalingCurve::Axis axis = ScalingCurve::Axis::Pixels;
        std::size_t number = 1; ///< is the axis' number, from 1
        std::size_t of = 1;
        int round = 0; ///< is 0 while programs are made
        int rounds = 1;
    };
    Turn turn() const;

    /// Returns the results of all finished rounds; an axis appears with its first one.
    const std::vector<ScalingCurve>& curves() const;

    /// Returns how many rounds the curves contain, so that a change of it means new curves.
    int rounds() const;

    std::string timer() const;
    const Errors& problems() const;

  private:
    class Implementation;
    explicit ScalingSweep(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
