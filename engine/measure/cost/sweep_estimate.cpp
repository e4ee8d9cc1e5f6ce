// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/sweep_estimate.h"

#include <utility>

namespace patina {
namespace {

/// Is the number of directions from whose time that of thousands is estimated.
constexpr int fewDirections = 64;

/// Counts the ground truth, a converged frame, and the exact frame, which is captured and timed as
/// a pair.
constexpr double exactFrames = 5.0;

/// Returns how many frames with every choice exact take as long as all points.
double framesOf(const SweepFrames& frames, int directions) {
    double count = exactFrames;
    for (const Choice& choice : frames.choices()) {
        for (std::size_t i = 1; i < choice.levels.size(); ++i) {
            const ChosenFrame own = frames.of({{choice.id, choice.levels[i].id}});
            count += 1.0 + 2.0 * own.view.environmentSamples / directions; // captured, and a pair
        }
    }
    return count;
}

} // namespace

double secondsOfSingles(const SweepFrames& frames, TimedFrames& drawn) {
    ChosenFrame few = frames.of({});
    const int all = std::exchange(few.view.environmentSamples, fewDirections);
    if (frames.isOfMaterial() || all <= fewDirections) {
        return 0.0;
    }
    drawn.timeOf(few.scene, few.view); // this only warms up
    const double exact = 1e-3 * drawn.timeOf(few.scene, few.view) * all / fewDirections;
    return exact * framesOf(frames, all);
}

} // namespace patina
