// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "measure/choice/choices.h"

namespace patina {

/// Holds what a sweep is doing.
struct SweepStep {
    enum class Work {
        GroundTruthFrame, ///< what errors are measured against
        ConvergedFrame,   ///< what those of fewer directions are measured against
        EmptyFrame,       ///< the time of a frame in which nothing that counts is shaded
        Point,
        Nothing ///< all is done
    };
    Work work = Work::GroundTruthFrame;
    ChosenLevels levels{};  ///< of the point
    std::size_t number = 1; ///< from 1 on, of those that are known to be done and to come
    std::size_t of = 1;
    double share = 0.0; ///< of it that is done, 0 .. 1
    /// That all single choices will take, about, where frames are so slow that this is known
    /// before; else 0.
    double secondsInAll = 0.0;

    /// Returns the share that is done of all that is known to be to do, 0 .. 1.
    double progress() const { return (double(number - 1) + share) / double(of); }

    friend bool operator==(const SweepStep&, const SweepStep&) = default;
};

} // namespace patina
