// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/choice/choices.h"
#include "measure/cost/cost_sweep.h"

namespace patina {

/// Holds the frames of a sweep: what is drawn for a point of its chart, and what is left without
/// it.
class SweepFrames {
  public:
    /// The subject's scene loses what is not measured.
    SweepFrames(CostSweep::Subject subject, const CostSweep::Options& options, glm::ivec2 size);

    /// Returns what can be computed more cheaply, as far as the options ask for it.
    const std::vector<Choice>& choices() const { return choices_; }
    bool isOfMaterial() const { return scope_ == Choice::Scope::Material; }
    const CostSweep::Subject& subject() const { return subject_; }
    const std::vector<bool>& counted() const { return counted_; } ///< by object: is measured

    /// Returns the frame as it is timed.
    ChosenFrame of(const ChosenLevels& levels) const;

    /// Returns the frame as it is captured, in whole floats; the picture's own choices say
    /// otherwise.
    ChosenFrame captured(const ChosenLevels& levels) const;

    /// Returns the frame in which nothing of what counts is shaded.
    ChosenFrame empty() const;

  private:
    CostSweep::Subject subject_;
    Choice::Scope scope_;
    glm::ivec2 size_;
    std::vector<Choice> choices_;
    std::vector<bool> counted_;
};

} // namespace patina
