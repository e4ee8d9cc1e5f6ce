// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "measure/choice/choices.h"

namespace patina {

/// Describes what a sweep is doing.
struct SweepStep {
    enum class Work {
        GroundTruthFrame, ///< draws the frame with which points are compared
        ConvergedFrame,   ///< draws the one for points of fewer directions
        EmptyFrame,       ///< times a frame without anything to shade
        Point,
        Nothing ///< says that all is done
    };
    Work work = Work::GroundTruthFrame;
    ChosenLevels levels{};  ///< are those of the point
    std::size_t number = 1; ///< is the step's number from 1, of those known so far
    std::size_t of = 1;
    double share = 0.0; ///< 0 .. 1, of the step that is done
    /// Is an estimate for all single choices, where frames are slow enough to make one; else 0.
    double secondsInAll = 0.0;

    /// Returns the share that is done of all steps known so far, 0 .. 1.
    double progress() const { return (double(number - 1) + share) / double(of); }

    friend bool operator==(const SweepStep&, const SweepStep&) = default;
};

} // namespace patina
