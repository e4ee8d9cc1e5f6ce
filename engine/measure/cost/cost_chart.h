// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "measure/choice/choices.h"
#include "measure/error/converged_frame.h"
#include "measure/error/frame_error.h"
#include "measure/time/choice_cost.h"
#include "measure/time/instruction_count.h"

namespace patina {

/// Holds one combination of levels with its time and its error.
struct CostPoint {
    ChosenLevels levels; ///< are those that are not exact
    FrameError error;
    ChoiceCost cost;
    std::optional<InstructionCount>
        instructions; ///< are those of its program; empty: not countable

    bool isExact() const { return levels.empty(); }

    friend bool operator==(const CostPoint&, const CostPoint&) = default;
};

/// Names a level that the device draws bit for bit as another one of the same choice.
struct SameLevel {
    std::string choice; ///< is a Choice::id
    std::string level;
    std::string as;  ///< is the level that it is drawn as
    int samples = 0; ///< per pixel, which the device takes for both; 0: the choice is of others

    friend bool operator==(const SameLevel&, const SameLevel&) = default;
};

/// Holds what was measured of a material in a scene.
struct CostChart {
    std::vector<Choice> choices;
    std::vector<CostPoint> points; ///< begin with the exact one; others follow as they are measured
    glm::ivec2 size{0};            ///< pixels of the frames
    std::size_t pixels = 0;        ///< counts those that are shaded
    double exactMilliseconds = 0.0; ///< is the time of the exact frame
    double emptyMilliseconds = 0.0; ///< is the time of a frame without anything to shade
    std::string timer;              ///< says how frames were timed, for users
    std::string groundTruth;        ///< says with what frames are compared, for users
    std::vector<SameLevel> same;    ///< have no points of their own
    std::optional<ConvergedRender> converged{}; ///< is what some points are compared with instead
    /// Names the graphics card that times are predicted for, "Steam Deck (RDNA 2)"; empty: they
    /// were measured here.
    std::string predictedFor{};
    std::size_t leftOut = 0; ///< counts possible points of the front that there was no time for

    /// Tells whether the point was compared with the converged render.
    bool isAgainstConverged(const CostPoint& point) const;

    /// Tells whether the point's ratio to the exact time is only a bound.
    RatioBound boundOf(const CostPoint& point) const;

    /// Returns the levels under which a point is listed: a level that is drawn as another one is
    /// replaced by that.
    ChosenLevels distinct(ChosenLevels levels) const;

    /// Returns the point of these levels, or of those that are drawn alike; null where it was not
    /// measured.
    const CostPoint* find(const ChosenLevels& levels) const;

    friend bool operator==(const CostChart&, const CostChart&) = default;
};

/// Says which levels are drawn alike: "Samples per pixel: 8 samples, 4 samples are all drawn with 4
/// here", or "Lobe: Table is drawn as Exact". Empty where all levels differ.
std::string sameText(const CostChart& chart);

/// Says which points were compared with a converged render, and how good that is; empty where none
/// were.
std::string convergedText(const CostChart& chart);

/// Says how many combinations were left out because there was no time; empty where none were.
std::string leftOutText(const CostChart& chart);

/// Returns the error by which points are ranked: the relative error that 99 of 100 pixels keep.
double errorOf(const CostPoint& point);

/// Tells whether two points cannot be told apart in time, or in their errors. Times that are given,
/// as predicted ones are, are told apart unless they are equal.
bool tiesInTime(const CostPoint& a, const CostPoint& b);
bool tiesInError(const CostPoint& a, const CostPoint& b);

/// Returns the indices of the other points that tie with this one in both.
std::vector<std::size_t> tiesOf(const std::vector<CostPoint>& points, const CostPoint& point);

/// Returns the indices of the points that are worth choosing, the fastest first: from the most
/// accurate one on, each that is faster than those before it by more than the noise. For each other
/// point one on the front has no larger error and cannot be told to be slower. Of points that
/// cannot be told apart one is on it: the exact one where it is among them.
std::vector<std::size_t> costFront(const std::vector<CostPoint>& points);

/// Tells how a point stands to the front.
enum class Standing {
    OnFront,
    Tie, ///< is kept from the front by noise only: it ties with a point on it, or is faster than
         ///< all that have no larger error, but not by more than the noise
    Beaten
};

/// Returns the standing of each point.
std::vector<Standing> standings(const std::vector<CostPoint>& points);

/// Returns the indices of the points that may be worth choosing: the front, the fastest first, then
/// its ties.
std::vector<std::size_t> frontAndTies(const std::vector<CostPoint>& points);

/// Limits the milliseconds of a frame, its error as by errorOf(), or both.
struct CostBudget {
    std::optional<double> milliseconds;
    std::optional<double> error;
};

/// Holds the point that a budget chooses.
struct BudgetAnswer {
    std::size_t point = 0; ///< is the index of one that fits, or else of the nearest
    bool fits = false;
};

/// Returns the point that fits the budget: the most accurate one that is fast enough, or the
/// fastest one that is accurate enough; of those that cannot be told from it in that, the best in
/// the other. Nothing is returned where there are no points.
std::optional<BudgetAnswer> bestFor(const CostBudget& budget, const std::vector<CostPoint>& points);

} // namespace patina
