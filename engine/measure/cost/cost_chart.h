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

/// One way to compute a frame: what it costs and how wrong it is.
struct CostPoint {
    ChosenLevels levels; ///< those that are not exact
    FrameError error;
    ChoiceCost cost;
    std::optional<InstructionCount> instructions; ///< of its program, where that can be counted

    bool isExact() const { return levels.empty(); }

    friend bool operator==(const CostPoint&, const CostPoint&) = default;
};

/// Represents a level that the device draws as it draws another one of the same choice, bit for
/// bit.
struct SameLevel {
    std::string choice; ///< Choice::id
    std::string level;
    std::string as;
    int samples = 0; ///< per pixel that the device looks at for both of them; 0: of no such choice

    friend bool operator==(const SameLevel&, const SameLevel&) = default;
};

/// Holds what was measured of a material in a scene.
struct CostChart {
    std::vector<Choice> choices;
    std::vector<CostPoint> points;  ///< the exact one first, the others in the order of measuring
    glm::ivec2 size{0};             ///< pixels of the frames
    std::size_t pixels = 0;         ///< that are shaded
    double exactMilliseconds = 0.0; ///< what the exact frame takes
    double emptyMilliseconds = 0.0; ///< what a frame takes of which nothing is shaded
    std::string timer;              ///< how frames were timed, for people
    std::string groundTruth;        ///< what errors are measured against, for people
    std::vector<SameLevel> same;    ///< which have no points of their own
    std::optional<ConvergedRender> converged{}; ///< what some errors are against instead
    std::size_t leftOut = 0; ///< combinations that may be on the front, for which there was no time

    /// Tells whether the point's errors are against that render.
    bool isAgainstConverged(const CostPoint& point) const;

    /// Returns what the point's ratio to the exact time says.
    RatioBound boundOf(const CostPoint& point) const;

    /// Returns the levels by which the points go: in place of one that is the same as another, that
    /// one.
    ChosenLevels distinct(ChosenLevels levels) const;

    /// Returns the point of these levels, or of those that are the same; null: it was not measured.
    const CostPoint* find(const ChosenLevels& levels) const;

    friend bool operator==(const CostChart&, const CostChart&) = default;
};

/// "Samples per pixel: 8 samples, 4 samples are all drawn with 4 here"; "Lobe: Table is drawn as
/// Exact" of other choices; empty where all levels differ.
std::string sameText(const CostChart& chart);

/// Returns which errors are against a converged render, and how good that is; empty where none are.
std::string convergedText(const CostChart& chart);

/// That combinations were left out for want of time, and how many; empty where none were.
std::string leftOutText(const CostChart& chart);

/// Returns the error by which points are compared: the relative error that 99 of 100 pixels keep.
double errorOf(const CostPoint& point);

/// Tells whether nobody can tell the two apart in time, or in their errors.
bool tiesInTime(const CostPoint& a, const CostPoint& b);
bool tiesInError(const CostPoint& a, const CostPoint& b);

/// Returns the other points that tie with this one in both.
std::vector<std::size_t> tiesOf(const std::vector<CostPoint>& points, const CostPoint& point);

/// Returns the points that are worth choosing, the fastest first: from the most accurate one on,
/// each that is faster than those before it by more than the noise. So each of the others has one
/// on the front that errs no more and is as fast as far as can be told, whatever else was measured;
/// of points that nobody can tell apart one is on it: the exact one where it is among them.
std::vector<std::size_t> costFront(const std::vector<CostPoint>& points);

/// Tells what a point is beside the front.
enum class Standing {
    OnFront,
    Tie, ///< only the noise keeps it from the front: it ties with one that is on it, or is faster
         ///< than all of those that err no more, but not by more than the noise
    Beaten
};

/// Returns the standing of each point.
std::vector<Standing> standings(const std::vector<CostPoint>& points);

/// Returns the points that may be worth choosing: the front, the fastest first, then its ties.
std::vector<std::size_t> frontAndTies(const std::vector<CostPoint>& points);

/// Holds what may be spent: milliseconds of a frame, or an error as errorOf() has it.
struct CostBudget {
    std::optional<double> milliseconds;
    std::optional<double> error;
};

/// Holds the point that fits the budget: the most accurate one that is fast enough, or the fastest
/// one that is accurate enough; of those that cannot be told from it in that, the best in the
/// other.
struct BudgetAnswer {
    std::size_t point = 0; ///< the one that fits, or else the nearest
    bool fits = false;
};
std::optional<BudgetAnswer> bestFor(const CostBudget& budget, const std::vector<CostPoint>& points);

} // namespace patina
